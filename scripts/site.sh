#!/usr/bin/env bash
# Makes pages for a browser of README.md, the documents and the schemas, with MkDocs (apt-get install mkdocs), and fails
# for links that lead nowhere. scripts/site.sh OUT, which is made, or replaced if this made it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if [[ $# -ne 1 || $1 == -* ]]; then
    echo 'usage: scripts/site.sh OUT' >&2
    exit 2
fi
out=$(realpath -m "$1")
if ! command -v mkdocs >/dev/null; then
    echo 'needs MkDocs (apt-get install mkdocs)' >&2
    exit 2
fi
if [[ -e $out && ! -e $out/sitemap.xml && -n $(ls -A "$out" 2>&1) ]]; then
    echo "$1 is there and no site; give another folder" >&2
    exit 2
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tree=$folder/tree

# The tree as it is, so that links between files hold, but of files that are no documents only those that are linked.
mkdir -p "$tree/assets"
cp README.md CHANGELOG.md CONTRIBUTING.md LICENSE "$tree"
cp -r docs "$tree"
cp -r assets/schema "$tree/assets"
documents=(*.md docs/*.md docs/decisions/*.md)
for document in "${documents[@]}"; do
    grep -oE '\]\([A-Za-z0-9_./-]+' "$document" | sed 's/^](//' | while read -r link; do
        file=$(realpath -ms --relative-to=. "$(dirname "$document")/$link")
        [[ ! -f $file || -e $tree/$file ]] || install -D -m 644 "$file" "$tree/$file"
    done || true
done
# What goes on in a list's item is indented by two in the documents; MkDocs takes it for the item's from four on.
(cd "$tree" && for document in "${documents[@]}"; do
    awk '/^(- |[0-9]+\. )/ { if (apart) print ""; apart = 0; more = /^-/ ? "  " : " "; print; next }
        /^[^ ]/ { more = ""; apart = 0 }
        /^$/ && more { apart = 1 }
        { print (/^  / ? more : "") $0 }' "$document" >"$folder/document"
    cp "$folder/document" "$document"
done)
{
    echo '# Schemas'
    echo
    echo 'For editors that complete and check as you type; [the fields of a scene](scene.md) as text.'
    echo
    for schema in assets/schema/*.json; do
        title=$(sed -n 's/^ *"title": *"\(.*\)",*$/\1/p' "$schema" | head -1)
        echo "- [$(basename "$schema")](../$schema)${title:+: $title}"
    done
} >"$tree/docs/schemas.md"

# What README.md lists under "Read on", in its order, then the others.
listed=$(sed -n '/^## Read on/,$p' README.md | tr '\n' ' ' | grep -oE '\]\([A-Za-z0-9_./-]+\.md\)' | tr -d ']()' | awk '!seen[$0]++')
others=$(cd "$tree" && ls docs/*.md | grep -vxF "$listed")
{
    printf 'site_name: Knuckle\ndocs_dir: %s\nsite_dir: %s\nuse_directory_urls: false\n' "$tree" "$folder/site"
    printf 'theme: mkdocs\nmarkdown_extensions:\n  - toc:\n      permalink: true\n'
    printf '      slugify: !!python/name:knuckle_site.slug\nnav:\n'
    printf '  - Home: README.md\n  - Guide:\n'
    printf '      - %s\n' $listed
    printf '  - More:\n'
    printf '      - %s\n' $others
} >"$folder/mkdocs.yml"
# Headings get the names that GitHub gives them: links in the documents are by these.
cat >"$folder/knuckle_site.py" <<'END'
import re

def slug(heading, separator):
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", separator)
END
log=$folder/log
PYTHONPATH=$folder mkdocs build --strict --config-file "$folder/mkdocs.yml" >"$log" 2>&1 || {
    grep -E '^(WARNING|ERROR)' "$log" >&2 || cat "$log" >&2
    exit 1
}

# MkDocs looks whether files are there, but not at the parts of pages.
python3 - "$folder/site" <<'END'
import pathlib, re, sys, urllib.parse

site = pathlib.Path(sys.argv[1])
text = {page: page.read_text() for page in site.rglob("*.html") if page.name not in ("404.html", "search.html")}
names = {page.resolve(): set(re.findall(r'\b(?:id|name)="([^"]+)"', body)) for page, body in text.items()}
broken = 0
for page, body in sorted(text.items()):
    for link in re.findall(r'\b(?:href|src)="([^"]+)"', body):
        address = urllib.parse.urlsplit(link)
        if address.scheme or link in ("#", ".") or link.startswith("/"):
            continue
        target = (page.parent / urllib.parse.unquote(address.path)).resolve() if address.path else page.resolve()
        part = urllib.parse.unquote(address.fragment)
        if not target.exists() or (part and target in names and part not in names[target]):
            print(f"{page.relative_to(site)}: {link} leads nowhere", file=sys.stderr)
            broken += 1
sys.exit(broken > 0)
END
rm -rf "$out"
mkdir -p "$(dirname "$out")"
cp -r "$folder/site" "$out"
echo "$1/index.html"
