#!/usr/bin/env python3
"""Checks that the manual and the completions know what the tool knows: cache_documented.py TOOL FOLDER"""

import pathlib
import re
import subprocess
import sys


def help_of(tool, *verb):
    return subprocess.run([tool, *verb, "--help"], capture_output=True, text=True, check=True).stdout


def section(text, title):
    return text.split(title + ":\n")[1].split("\n\n")[0] if title + ":\n" in text else ""


def main():
    tool, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    manual = (folder / "anteroom-cache.1").read_text().replace("\\-", "-")
    bash = (folder / "completion/anteroom-cache.bash").read_text()
    zsh = (folder / "completion/_anteroom-cache").read_text()
    texts = {"the manual": manual, "bash's completion": bash, "zsh's completion": zsh}
    faults = []

    def expect(word):
        for name, text in texts.items():
            if not re.search(rf"(?<![-\w]){re.escape(word)}(?![-\w])", text):
                faults.append(f"{name} does not know {word}")

    general = help_of(tool)
    verbs = re.findall(r"^  ([a-z]+) ", section(general, "Subcommands"), re.MULTILINE)
    if len(verbs) < 12:
        faults.append(f"the help names only {verbs}")
    for verb in verbs:
        expect(verb)
    for text in [general, *(help_of(tool, verb) for verb in verbs)]:
        for line in section(text, "Options").splitlines():
            for option in re.findall(r"(?<![-\w])(--[a-z]+|-n)\b", line[:30]):
                expect(option)
    # bash offers the verbs, and what a verb takes.
    def completed(words):
        script = f"source {folder}/completion/anteroom-cache.bash; COMP_WORDS=(anteroom-cache {words}); " \
            "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _anteroom_cache; echo ${COMPREPLY[*]}"
        return subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True).stdout.strip()

    for words, wanted in {"ex": "explain export", "list --so": "--sort", "list --sort a": "age",
                          "--file list pru": "prune"}.items():
        if completed(words) != wanted:
            faults.append(f"bash completes '{words}' with '{completed(words)}'")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
