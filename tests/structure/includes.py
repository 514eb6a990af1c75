#!/usr/bin/env python3
"""Checks who may include whom: includes.py ROOT [--self-check]

The rules are those of the README files: shaders <- gen <- layer/render <- layer/gl <- layer/egl <- layer/loader, and
gen <- layer/cache <- layer/vulkan; layer/vulkan and tests/reference implement layer/render; layer/tools stand above all;
demos and tests/conformance know nothing of ours but the GL and EGL headers. Every folder of shaders, gen, layer and demos
has a rule.
"""

import argparse
import pathlib
import re
import sys
import tempfile

SOURCES = {".h", ".hpp", ".c", ".cpp", ".inl"}
SHADERS = {".glsl", ".vert", ".frag", ".comp"}
TOP_LEVEL = {"cmake", "layer", "gen", "shaders", "demos", "tests"}
RULED = {"shaders", "gen", "layer", "demos"}
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')

VULKAN = r"vulkan/|volk\.h|vk_|vma"
GL_API = r"GLES/|EGL/|KHR/"
WINDOWS = r"GLFW/|xcb/|X11/|wayland"
PICTURES = r"OpenImageIO/"
TESTING = r"gtest/|gmock/|benchmark/"
GL_FOREIGN = [VULKAN, r"EGL/", r"glslang/", WINDOWS, PICTURES, TESTING]

ANYTHING = r""


def renderer(*parts):
    """The rule of a part of layer/vulkan: of the renderer it may include these parts."""
    ours = [f"layer/vulkan/{part}" for part in parts]
    return (ours + ["layer/cache", "layer/render", "gen"], [r"EGL/", r"GLFW/", PICTURES, TESTING])


WHOLE_RENDERER = renderer(
    "vulkan_device.h", "context.h", "device", "debug", "pipelines", "resources", "geometry", "plan", "recording",
    "images", "windows"
)

# Folder or file: (what of ours it may include: folders or single files, which foreign headers it may not include).
# The longest that holds a file rules it.
RULES = {
    "shaders": (["shaders"], [ANYTHING]),
    "gen": (["gen"], [VULKAN, r"EGL/", WINDOWS, PICTURES, TESTING]),
    "layer/cache": (["layer/cache", "gen"], [VULKAN, GL_API, WINDOWS, PICTURES, TESTING]),
    "layer/render": (["layer/render", "gen"], [VULKAN, r"EGL/", WINDOWS, PICTURES, TESTING]),
    "layer/gl": (["layer/gl", "layer/render", "gen"], GL_FOREIGN),
    # Chapters of the specification know of each other what is bound and what is drawn to, and no more.
    **{
        f"layer/gl/{folder}": (
            [f"layer/gl/{name}" for name in [folder, "context", "queries", "debug", *others]] + ["layer/render", "gen"],
            GL_FOREIGN,
        )
        for folder, others in {
            "vertices": ["textures"],
            "fragments": [],
            "textures": ["framebuffers"],
            "framebuffers": ["textures"],
        }.items()
    },
    "layer/egl": (
        ["layer/egl", "layer/gl/front_end.h", "layer/render", "gen"],
        [VULKAN, r"glslang/", r"GLFW/", PICTURES, TESTING],
    ),
    "layer/vulkan": WHOLE_RENDERER,
    # What others know of the renderer, in their terms.
    "layer/vulkan/vulkan_device.h": (["layer/render", "gen"], [VULKAN, GL_API, WINDOWS, PICTURES, TESTING]),
    "layer/vulkan/device": renderer("device", "debug/labels.h", "vulkan_device.h"),
    # It makes the parts that contexts share.
    "layer/vulkan/device/device.cpp": WHOLE_RENDERER,
    "layer/vulkan/debug": renderer("debug", "device"),
    "layer/vulkan/pipelines": renderer("pipelines", "device", "debug"),
    "layer/vulkan/resources": renderer("resources", "device"),
    # Neither of these two records anything, or knows of the other.
    "layer/vulkan/geometry": renderer("geometry", "pipelines/vertex_layout.h", "resources", "device"),
    "layer/vulkan/plan": renderer("plan", "pipelines", "resources", "device"),
    # Of the two before it sees the results alone.
    "layer/vulkan/recording": renderer(
        "recording", "geometry/geometry.h", "plan/draw_plan.h", "pipelines", "resources", "device"
    ),
    "layer/vulkan/images": renderer("images", "recording", "pipelines/own_shaders.h", "resources", "device"),
    "layer/vulkan/windows": renderer("windows", "images", "recording", "resources", "device"),
    "layer/loader": (
        ["layer/loader", "layer/egl", "layer/gl", "layer/render", "gen", "layer/vulkan/vulkan_device.h"],
        [VULKAN, r"GLFW/", PICTURES, TESTING],
    ),
    "layer/tools": (["layer", "gen"], [VULKAN, WINDOWS, PICTURES, TESTING]),
    # It asks whatever libraries there are, and so knows none of ours.
    "layer/tools/info": (["layer/tools/info", "layer/egl/eglanteroom.h"], [VULKAN, WINDOWS, PICTURES, TESTING]),
    "demos": (["demos"], [VULKAN, TESTING]),
    # `rooms bench` measures in fresh processes, as the benchmark does.
    "demos/program": (["demos", "tests/measure"], [VULKAN, TESTING]),
    "tests/conformance": (["tests/conformance"], [VULKAN]),
    "tests/windows": (["tests/windows", "tests/egl/egl_fixture.h"], [VULKAN]),
    "tests/bench": (["tests/bench", "tests/measure"], [VULKAN]),
    "tests/compare": (["tests/compare", "tests/measure"], [VULKAN]),
    "tests/vulkan_layer": (["tests/vulkan_layer"], [GL_API]),
    "tests/reference": (["tests/reference", "layer/render", "gen"], [VULKAN, r"EGL/", WINDOWS]),
    "tests/gen": (["tests/gen", "gen"], [VULKAN, r"EGL/"]),
}


def sources(root, suffixes=SOURCES):
    for top in sorted(TOP_LEVEL):
        for path in sorted((root / top).rglob("*")):
            if path.suffix in suffixes and path.is_file():
                yield path


def rule_for(relative):
    parents = [path.as_posix() for path in (relative, *relative.parents)]
    return next((parent for parent in parents if parent in RULES), None)


def resolve(root, path, name, by_name):
    """The included file relative to the root, or None when it is not in the tree.

    What is in none of the usual places is found by a target's include folders: it is taken for the file of that name.
    """
    inside = path.relative_to(root)
    for base in [path.parent, root, root / "layer", root / inside.parts[0]]:
        candidate = (base / name).resolve()
        if candidate.is_file() and candidate.is_relative_to(root):
            return candidate.relative_to(root).as_posix()
    return next((found for found in by_name.get(name.split("/")[-1], ()) if found.endswith("/" + name)), None)


def allowed_inside(target, allowed):
    return any(target == entry or target.startswith(entry + "/") for entry in allowed)


def check_file(root, path, by_name):
    relative = path.relative_to(root)
    folder = rule_for(relative)
    if folder is None:
        if relative.parts[0] in RULED:
            yield f"{relative.as_posix()}:1: no rule says what it may include"
        return
    allowed, forbidden = RULES[folder]
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        name = match.group(1) or match.group(2)
        where = f"{relative.as_posix()}:{number}"
        target = resolve(root, path, name, by_name if match.group(1) else {})
        if target is not None:
            if not allowed_inside(target, allowed):
                yield f"{where}: {folder} may not include {target}"
        elif name.split("/")[0] in TOP_LEVEL:
            # Made by the build, so not in the tree; its name tells where it belongs.
            if not allowed_inside(name, allowed):
                yield f"{where}: {folder} may not include {name}"
        elif any(re.match(pattern, name) for pattern in forbidden):
            yield f"{where}: {folder} may not include <{name}>"


def check_tree(root):
    for top in sorted(TOP_LEVEL):
        if (root / top).is_dir() and not (root / top / "README.md").is_file():
            yield f"{top}: no README.md"


def check(root):
    faults = list(check_tree(root))
    files = list(sources(root, SOURCES | SHADERS))
    by_name = {}
    for path in files:
        by_name.setdefault(path.name, []).append(path.relative_to(root).as_posix())
    for path in files:
        faults.extend(check_file(root, path, by_name))
    if not files:
        faults.append(f"no sources below {root}")
    return faults


def self_check():
    """Every line below breaks a rule but the last ones, and the checker must say so."""
    bad = {
        "layer/gl/a.cpp": "#include <vulkan/vulkan.h>",
        "layer/gl/b.cpp": '#include "layer/vulkan/vulkan_device.h"',
        "layer/gl/c.cpp": '#include "../egl/display.h"',
        "layer/gl/fragments/m.cpp": '#include "layer/gl/textures/texture.h"',
        "layer/render/d.h": "#  include <volk.h>",
        "layer/egl/e.cpp": '#include "layer/vulkan/vulkan_device.h"',
        "layer/egl/n.cpp": '#include "layer/gl/context/context.h"',
        "layer/vulkan/f.cpp": '#include "layer/gl/state.h"',
        "layer/vulkan/device/a.cpp": '#include "layer/vulkan/recording/recorder.h"',
        "layer/vulkan/geometry/a.cpp": '#include "layer/vulkan/recording/recorder.h"',
        "layer/vulkan/images/a.cpp": '#include "layer/vulkan/context.h"',
        "layer/vulkan/plan/a.cpp": '#include "layer/vulkan/geometry/geometry.h"',
        "layer/vulkan/recording/a.cpp": '#include "layer/vulkan/images/clear.h"',
        "layer/cache/m.cpp": '#include "layer/render/state.h"',
        "layer/cache/n.h": '#include "layer/vulkan/vulkan_device.h"',
        "layer/render/o.h": '#include "layer/cache/store.h"',
        "layer/gl/p.cpp": '#include "layer/cache/store.h"',
        "layer/loader/q.cpp": '#include "layer/tools/cache/read.h"',
        "layer/loader/r.cpp": '#include "layer/vulkan/device/memory.h"',
        "layer/tools/info/s.cpp": '#include "layer/egl/display.h"',
        "layer/tools/cache/t.cpp": "#include <vulkan/vulkan.h>",
        "layer/other/u.cpp": "",
        "gen/v.cpp": '#include "layer/cache/store.h"',
        "shaders/w.glsl": '#include "gen/key.h"',
        "demos/water/x.cpp": '#include "in_tests_alone.h"',
        "tests/conformance/y.cpp": "#include <vulkan/vulkan.h>",
        "gen/g.cpp": '#include "layer/render/state.h"',
        "gen/deep/h.h": "#include <vulkan/vulkan_core.h>",
        "demos/room/i.cpp": '#include "gen/key.h"',
        "tests/conformance/j.cpp": '#include "gen/key.h"',
        "layer/loader/k.cpp": "#include <OpenImageIO/imageio.h>",
        "tests/reference/l.cpp": '#include "gen/not_there_but_ours.h"\n#include "layer/gl/state.h"',
    }
    good = {
        "layer/gl/state.h": '#include "layer/render/state.h"',
        "layer/gl/textures/texture.h": '#include "layer/gl/framebuffers/framebuffer.h"',
        "layer/render/state.h": '#include "gen/key.h"\n#include <array>',
        "layer/egl/display.h": '#include "layer/gl/front_end.h"',
        "layer/cache/store.h": '#include "gen/key.h"',
        "layer/loader/renderers.cpp": '#include "layer/vulkan/vulkan_device.h"\n#include "layer/egl/display.h"',
        "layer/tools/cache/read.h": '#include "layer/cache/store.h"\n#include "layer/vulkan/vulkan_device.h"',
        "layer/vulkan/vulkan_device.h": '#include "layer/render/state.h"',
        "layer/vulkan/pipelines/library.cpp": '#include "layer/cache/store.h"',
        "layer/vulkan/context.h": '#include "layer/vulkan/recording/recorder.h"',
        "layer/vulkan/device/device.cpp": '#include "layer/vulkan/context.h"',
        "layer/vulkan/device/memory.h": "#include <volk.h>",
        "layer/vulkan/geometry/geometry.h": "#include <volk.h>",
        "layer/vulkan/images/clear.h": '#include "layer/render/state.h"',
        "layer/vulkan/recording/recorder.h": '#include "layer/vulkan/geometry/geometry.h"',
        "gen/key.h": "#include <GLES/gl.h>",
        "demos/room/mesh.cpp": '#include "mesh.h"\n#include <GLES/gl.h>',
        "demos/room/mesh.h": "",
        "demos/program/bench.cpp": '#include "in_tests_alone.h"',
        "tests/measure/in_tests_alone.h": "",
        "shaders/spot.glsl": "float spot() { return 1; }",
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder).resolve()
        for name, text in {**good, **bad}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text + "\n")
        for top in TOP_LEVEL:
            (root / top).mkdir(exist_ok=True)
            (root / top / "README.md").write_text("x\n")
        (root / "demos/README.md").unlink()
        faults = check(root)
    missed = [name for name in bad if not any(fault.startswith(name + ":") for fault in faults)]
    wrongly = [fault for fault in faults if any(fault.startswith(name + ":") for name in good)]
    if "demos: no README.md" not in faults:
        missed.append("demos/README.md")
    return [f"self-check: fault not seen in {name}" for name in missed] + [
        f"self-check: wrongly reported: {fault}" for fault in wrongly
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--self-check", action="store_true", help="check that broken rules are seen, in a temporary tree")
    arguments = parser.parse_args()
    faults = self_check() if arguments.self_check else check(arguments.root.resolve())
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
