#!/usr/bin/env python3
"""Says which links of a site lead nowhere: links.py FOLDER. Ends with 1 if there is one."""
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.places = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.links.add(value)
            if name in ("id", "name") and value:
                self.places.add(value)


root = pathlib.Path(sys.argv[1]).resolve()
pages = {path: Page(path.read_text(encoding="utf-8")) for path in root.rglob("*.html")}
dead = checked = 0
for path, page in pages.items():
    for link in sorted(page.links):
        parts = urllib.parse.urlsplit(link)
        if parts.scheme or parts.netloc or path.name == "404.html":
            continue
        target = path
        if parts.path:
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve()
        if target.is_dir():
            target = target / "index.html"
        place = urllib.parse.unquote(parts.fragment)
        checked += 1
        known = pages.get(target)
        if place == "nested-classes":  # Doxygen 1.9.4 heads private classes that it leaves out
            place = ""
        if not target.exists() or (place and known and not place.startswith("__") and place not in known.places):
            print(f"{path.relative_to(root)}: {link} leads nowhere")
            dead += 1
print(f"{checked} links of {len(pages)} pages, {dead} dead")
sys.exit(1 if dead else 0)
