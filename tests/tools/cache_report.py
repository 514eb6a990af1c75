#!/usr/bin/env python3
"""Checks the page of `anteroom-cache report` in a browser: cache_report.py TOOL PROGRAM CHROMIUM [KEEP_FOLDER]"""

import json
import os
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile
from html.parser import HTMLParser

HOSTILE = "fragment </script><script>document.title='taken'</script><img src=x onerror=\"document.title='taken'\">"
# Run in the page after its own script; the result goes where --dump-dom shows it.
CLICKS = """<script>
const click = one => one.dispatchEvent(new MouseEvent('click', {bubbles: true}));
const header = name => [...document.querySelectorAll('th')].find(cell => cell.textContent === name);
const keys = () => [...document.querySelectorAll('tr.row')].map(row => row.id);
const seen = {};
click(header('compile'));
seen.longest = keys();
click(header('compile'));
seen.shortest = keys();
click(document.getElementById(seen.shortest[0]));
seen.opened = document.querySelectorAll('tr.more').length;
click(document.querySelector('tr.row'));
seen.closed = document.querySelectorAll('tr.more').length;
document.getElementById('filter').value = 'fog';
document.getElementById('filter').dispatchEvent(new Event('input'));
seen.fog = keys();
click(document.querySelectorAll('svg rect')[0]);
seen.revealed = keys().length;
document.body.append(Object.assign(document.createElement('pre'), {id: 'seen', textContent: JSON.stringify(seen)}));
</script>"""


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.rows, self.bars, self.title, self.code, self.kinds, self.seen = [], [], "", "", set(), ""
        self.inside = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "tr" and "row" in attributes.get("class", "").split():
            self.rows.append(attributes["id"])
        if tag == "rect":
            self.bars.append(attributes)
        if "pre" in self.inside and tag == "i":
            self.kinds.add(attributes["class"])
        if tag not in ("meta", "input", "br", "link", "img"):
            self.inside.append("seen" if attributes.get("id") == "seen" else tag)

    def handle_endtag(self, tag):
        if self.inside:
            self.inside.pop()

    def handle_data(self, data):
        if self.inside[-1:] == ["title"] and "svg" not in self.inside:
            self.title += data
        if "pre" in self.inside:
            self.code += data
        if "seen" in self.inside:
            self.seen += data


class Browser:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, address, *options):
        command = [self.program, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--hide-scrollbars",
                   f"--user-data-dir={self.folder}/profile", "--virtual-time-budget=2000", *options, address]
        environment = {**os.environ, "HOME": str(self.folder)}
        return subprocess.run(command, capture_output=True, text=True, timeout=1200, check=True, env=environment).stdout

    def page(self, file, wish=""):
        return Page(self.run(f"file://{file}#{wish}", "--dump-dom"))


def check(tool, program, chromium, folder):
    environment = {**os.environ, "ANTEROOM_CACHE": "on", "ANTEROOM_CACHE_DIR": str(folder)}
    for argument in ([], [], ["fog"]):
        subprocess.run([program, *argument], check=True, capture_output=True, env=environment)
    cache, file = folder / "anteroom.db", folder / "report.html"

    def answer(*arguments):
        command = [tool, "--json", "--file", str(cache), *arguments]
        return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)

    # One row whose text is markup; its key says so, and it stays a row of text.
    with sqlite3.connect(cache) as database:
        database.execute("UPDATE shader SET description = ? WHERE number IN (SELECT min(number) FROM shader)", (HOSTILE,))
    made = answer("report", str(file))
    shaders, pipelines = answer("list"), answer("list", "--pipelines")
    assert (made["shaders"], made["pipelines"]) == (len(shaders), len(pipelines)), made

    text = file.read_text()
    addresses = [a for a in re.findall(r"https?://[^\"' ]*", text) if a != "http://www.w3.org/2000/svg"]
    assert not addresses and not re.search(r"<link|<script[^>]+src=|@import|url\(", text), "the page needs other files"

    browser = Browser(chromium, folder)
    uses = {row["key"]: row["uses"] for row in [*shaders, *pipelines]}
    times = {row["key"]: row.get("compile_us", row.get("create_us")) for row in [*shaders, *pipelines]}
    first = browser.page(file)
    assert first.title == "Anteroom's shader cache", first.title
    assert sorted(first.rows) == sorted(uses), "a row each"
    assert [uses[key] for key in first.rows] == sorted(uses.values(), reverse=True), "the most used first"
    heights = [float(bar["height"]) for bar in first.bars]
    assert len(heights) == len(uses) and heights == sorted(heights, reverse=True) and heights[0] > 100, heights

    sorted_page = browser.page(file, "sort=compile")
    assert [times[key] for key in sorted_page.rows] == sorted(times.values()), "the shortest first"

    shader = next(row for row in shaders if "fog=exp" in row["description"] and row["kind"] == "fragment")
    opened = browser.page(file, f"open={shader['key']}")
    assert opened.code == answer("show", shader["key"])["glsl"], "the GLSL, letter for letter"
    assert {"c", "d", "k", "t", "n", "f"} <= opened.kinds, opened.kinds

    clicked = folder / "clicked.html"
    clicked.write_text(text.replace("</html>", CLICKS + "</html>"))
    seen = json.loads(browser.page(clicked).seen)
    assert [times[key] for key in seen["longest"]] == sorted(times.values(), reverse=True), seen
    assert [times[key] for key in seen["shortest"]] == sorted(times.values()), seen
    assert (seen["opened"], seen["closed"]) == (1, 0), seen
    assert 0 < len(seen["fog"]) < len(uses) and shader["key"] in seen["fog"], seen
    assert seen["revealed"] == len(uses), seen
    for name, size in (("light", "1200,1400"), ("narrow", "420,900")):
        browser.run(f"file://{file}#open={shader['key']}", f"--screenshot={folder}/{name}.png", f"--window-size={size}")
        assert (folder / f"{name}.png").stat().st_size > 20000


def main():
    tool, program, chromium = sys.argv[1:4]
    if not pathlib.Path(chromium).exists():
        print("there is no Chromium: cmake/install_dependencies installs it")
        return 1
    if len(sys.argv) > 4:
        folder = pathlib.Path(sys.argv[4])
        folder.mkdir(parents=True, exist_ok=True)
        check(tool, program, chromium, folder.resolve())
    else:
        with tempfile.TemporaryDirectory() as folder:
            check(tool, program, chromium, pathlib.Path(folder).resolve())
    return 0


if __name__ == "__main__":
    sys.exit(main())
