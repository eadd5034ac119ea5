#!/usr/bin/env bash
# Pages of all documents, and links to nowhere found. Without MkDocs only what is said then.
# tests/scripts/site_test.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
root=$PWD
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
fail() {
    printf '%s\n' "$@" >&2
    failed=1
}
# refused WORD argument...: exit code 2, and one line with the word.
refused() {
    local word=$1 code=0 said
    shift
    said=$(bash scripts/site.sh "$@" 2>&1) || code=$?
    [[ $code == 2 && $said == *"$word"* && $said != *$'\n'* ]] || fail "site.sh $*: $code $said"
}

refused usage
if ! command -v mkdocs >/dev/null; then
    refused 'apt-get install mkdocs' "$folder/site"
    exit $failed
fi
mkdir "$folder/mine"
touch "$folder/mine/file"
refused 'no site' "$folder/mine"

bash scripts/site.sh "$folder/site" >/dev/null
for document in docs/*.md docs/decisions/*.md; do
    page=$folder/site/${document%.md}.html
    [[ -e ${page/README/index} ]] || fail "no page of $document"
done
for schema in assets/schema/*.json; do
    [[ -e $folder/site/$schema ]] || fail "no $schema"
done
grep -q '<li>' "$folder/site/docs/actors.html" || fail 'no list in actors.html'
! grep -rnE '^- <code>' --include='*.html' "$folder/site" || fail 'a list that is none'
# Again, in place of the last.
bash scripts/site.sh "$folder/site" >/dev/null

# A link to a file, and one to a heading, that are not there.
mkdir "$folder/tree"
cp -r README.md CHANGELOG.md CONTRIBUTING.md LICENSE docs scripts "$folder/tree"
for name in app assets cmake render shaders sim tests tools; do ln -s "$root/$name" "$folder/tree"; done
cd "$folder/tree"
broken() {
    local link=$1 word=$2 said
    cp "$root/docs/python.md" docs/python.md
    echo "[There]($link)" >>docs/python.md
    ! said=$(bash scripts/site.sh "$folder/broken" 2>&1) || fail "$link is not found broken"
    [[ $said == *"$word"* ]] || fail "$link: $said"
    [[ ! -e $folder/broken ]] || fail "$link: a site all the same"
}
broken nowhere.md nowhere.md
broken golden.md#nowhere 'golden.html#nowhere leads nowhere'
exit $failed
