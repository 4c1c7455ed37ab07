#!/bin/sh
# Builds the pages as a site, with the C++ reference: docs/site/build.sh [FOLDER], default build/site/html. Open
# index.html of the folder. Ends with 77 where a tool is missing, with another code than 0 at a warning or a dead link.
set -eu

root=$(cd "$(dirname "$0")/../.." && pwd)
html=$(realpath -m "${1:-$root/build/site/html}")
pages=$html.pages
katex=/usr/share/javascript/katex

missing=
for tool in mkdocs doxygen python3; do command -v "$tool" >/dev/null || missing="$missing $tool"; done
[ -d /usr/share/mkdocs/themes/material ] || missing="$missing mkdocs-material"
[ -d "$katex" ] || missing="$missing libjs-katex"
if [ -n "$missing" ]; then
  echo "the site needs$missing: apt-get install mkdocs mkdocs-material doxygen libjs-katex" >&2
  exit 77
fi

# The pages lie as in the checkout, so that their links are right in both places.
rm -rf "$pages" "$html"
mkdir -p "$pages" "$html"
cd "$root"
cp -r README.md CONTRIBUTING.md CHANGELOG.md CITATION.cff LICENSE docs "$pages"
find cases -name '*.toml' | cpio --quiet -pdm "$pages" 2>/dev/null || cp -r cases "$pages"
rm -rf "$pages/docs/site" "$pages/cases/program"
cp docs/site/katex.js docs/site/site.css "$pages"
cp -rL "$katex" "$pages/katex"
mkdir "$pages/cpp"
{
  cat docs/site/Doxyfile
  echo "OUTPUT_DIRECTORY = $pages"
  echo "HTML_OUTPUT = cpp"
} | doxygen -
FURNAS_SITE_PAGES=$pages FURNAS_SITE_HTML=$html mkdocs --quiet build --strict --config-file docs/site/mkdocs.yml
rm -rf "$pages"
python3 docs/site/links.py "$html"
