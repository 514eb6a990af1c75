#!/usr/bin/env python3
"""Makes of Khronos' registry what this library needs: registry.py GL_XML EXTENSIONS_INC FOLDER

What is offered is EXTENSIONS_INC's decision: an extension that it lists brings its commands.

  core_commands.inc  ANTEROOM_COMMAND(name): the commands of OpenGL ES 1.1, sorted
  commands.inc       the same with those of the extensions
  enums.inc          ANTEROOM_ENUM(name, value): a name for each enumerant of any GL, sorted by value
  gl.h               what <GLES/glext.h> lacks: enumerants, types and prototypes of the extensions
  aliases.cpp        commands of extensions that are core commands under another name
"""

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

# Extensions whose names Khronos did not register. They bring no commands.
UNREGISTERED = {
    "GL_ATIX_texture_env_combine3",
    "GL_ATIX_texture_env_route",
    "GL_EXT_compressed_ETC1_RGB8_sub_texture",
    "GL_OES_EGL_sync",
}
# Commands that the registry gives to ES, too, for textures of one dimension and EXT_direct_state_access.
NOT_IN_ES = {"glTexStorage1DEXT", "glTextureStorage1DEXT", "glTextureStorage2DEXT", "glTextureStorage3DEXT"}

MADE = "Made by layer/gl/registry.py of Khronos' gl.xml."


def names(elements, kind):
    return [item.get("name") for element in elements for item in element.findall(kind)]


def of_es(extension):
    """What an extension is on ES 1.x: that of ES 2 where the registry says nothing of ES 1.x."""
    requires = extension.findall("require")
    own = [require for require in requires if require.get("api") in (None, "gles1")]
    return own if names(own, "command") or names(own, "enum") else [r for r in requires if r.get("api") == "gles2"]


def text_of(element):
    return re.sub(r"\s+", " ", "".join(element.itertext())).strip()


class Registry:
    def __init__(self, path, extensions):
        root = ElementTree.parse(path).getroot()
        registered = {extension.get("name"): extension for extension in root.find("extensions")}
        unknown = [name for name in extensions if name not in registered and name not in UNREGISTERED]
        if unknown:
            sys.exit(f"{path} knows no {', '.join(unknown)}")
        core = [r for f in root.findall("feature") if f.get("api") == "gles1" for r in f.findall("require")]
        added = [r for name in extensions if name in registered for r in of_es(registered[name])]

        self.commands = {command.find("proto/name").text: command for command in root.find("commands")}
        self.core_commands = sorted(set(names(core, "command")))
        self.extension_commands = sorted(set(names(added, "command")) - NOT_IN_ES)
        self.own_enums = list(dict.fromkeys(names(core, "enum") + names(added, "enum")))
        self.enums = {}
        for group in root.findall("enums"):
            for enum in group.findall("enum"):
                if enum.get("api") in (None, "gles1", "gles2"):
                    self.enums[enum.get("name")] = (int(enum.get("value"), 0), group.get("type") == "bitmask", enum)
        self.types = {item.findtext("name"): item for item in root.find("types") if item.find("name") is not None}

    def parameters(self, command):
        return [(text_of(p), p.findtext("name"), p.findtext("ptype")) for p in self.commands[command].findall("param")]

    def prototype(self, command):
        parameters = ", ".join(declaration for declaration, _, _ in self.parameters(command)) or "void"
        proto = self.commands[command].find("proto")
        result = text_of(proto).removesuffix(command).strip()
        return f"GL_API {result} GL_APIENTRY {command}({parameters})"


def command_list(commands):
    return f"// {MADE}\n" + "".join(f"ANTEROOM_COMMAND({name})\n" for name in commands)


def enum_list(registry):
    """Bits and small numbers have too many names; of several the first is ours, or else the shortest."""
    own = {name: rank for rank, name in enumerate(registry.own_enums)}
    best = {}
    for name, (value, bits, _) in registry.enums.items():
        if bits or not 0x100 <= value <= 0xFFFF:
            continue
        rank = (own.get(name, len(own)), len(name), name)
        best[value] = min(best.get(value, rank), rank)
    rows = (f"ANTEROOM_ENUM({name}, 0x{value:04X})\n" for value, (_, _, name) in sorted(best.items()))
    return f"// {MADE}\n" + "".join(rows)


def header(registry):
    text = f"// {MADE}\n#pragma once\n\n#include <GLES/gl.h>\n#include <GLES/glext.h>\n\n"
    for name in registry.own_enums:
        element = registry.enums[name][2]
        text += f"#ifndef {name}\n#define {name} {element.get('value')}{element.get('type', '')}\n#endif\n"
    text += '\nextern "C" {\n'
    used = {kind for command in registry.extension_commands for _, _, kind in registry.parameters(command)}
    for name in sorted(used & registry.types.keys()):
        declaration = text_of(registry.types[name])
        if "(" in declaration:  # the others are in the headers
            text += declaration.replace("( *", "(GL_APIENTRY *") + "\n"
    text += "".join(registry.prototype(command) + ";\n" for command in registry.extension_commands)
    return text + "}\n"


def aliases(registry):
    text = f'// {MADE}\n#include "registry/gl.h"\n'
    for command in registry.extension_commands:
        core = re.sub(r"[A-Z]+$", "", command)
        if core in registry.core_commands:
            arguments = ", ".join(name for _, name, _ in registry.parameters(command))
            text += f"\n{registry.prototype(command)} {{\n  return {core}({arguments});\n}}\n"
    return text


def main():
    gl_xml, extensions_inc, folder = (pathlib.Path(argument) for argument in sys.argv[1:])
    listed = re.findall(r"^ANTEROOM_EXTENSION\((\w+),", extensions_inc.read_text(), re.MULTILINE)
    registry = Registry(gl_xml, ["GL_" + name for name in listed])
    folder.mkdir(parents=True, exist_ok=True)
    every = sorted(registry.core_commands + registry.extension_commands)
    (folder / "core_commands.inc").write_text(command_list(registry.core_commands))
    (folder / "commands.inc").write_text(command_list(every))
    (folder / "enums.inc").write_text(enum_list(registry))
    (folder / "gl.h").write_text(header(registry))
    (folder / "aliases.cpp").write_text(aliases(registry))


if __name__ == "__main__":
    main()
