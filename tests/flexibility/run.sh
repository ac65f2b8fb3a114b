#!/bin/sh
# What three edits of a material take: as a graph, which is read again, and as the function written by hand,
# which is built again. The edits are the patches beside this file. Needs git, cargo and a POSIX shell; works in
# a copy of the last commit, in a folder of its own that is removed afterwards. Takes some ten minutes, most of
# it for the first build.
#
#     tests/flexibility/run.sh
set -eu

here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
copy="$work/copy"
git clone --quiet "$(git -C "$here" rev-parse --show-toplevel)" "$copy"
cd "$copy"
# Whoever has built dependencies before may name the folder in CARGO_TARGET_DIR.
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$work/target}"
program="$CARGO_TARGET_DIR/release/phenomenon"
graph=graphs/glass/advanced_glass.json

render() { # ENGINE PICTURE
    "$program" render "$graph" --engine "$1" --set opacity=0.6 --size 64x64 --spp 4 -o "$2" \
        >"$work/told" 2>&1 || { cat "$work/told" >&2; exit 1; }
}

milliseconds() {
    # Not every date knows parts of a second; those that do not print an N.
    now=$(date +%s%N)
    case $now in
        *N) echo "$(date +%s)000" ;;
        *) echo "${now%??????}" ;;
    esac
}

# Applies a patch, runs a command until new pixels are there, and prints lines, files and seconds.
measured() { # PATCH COMMAND...
    patch=$1
    shift
    git apply --whitespace=nowarn "$here/$patch.patch"
    lines=$(git diff --numstat | awk '{ added += $1; removed += $2 } END { print "+" added " -" removed }')
    files=$(git diff --numstat | wc -l | tr -d ' ')
    start=$(milliseconds)
    "$@"
    end=$(milliseconds)
    seconds=$(awk "BEGIN { printf \"%.2f\", ($end - $start) / 1000 }")
    printf ' %s | %s | %s |' "$lines" "$files" "$seconds"
}

by_graph() {
    render auto "$work/graph.png"
}

by_hand() {
    cargo build --release --locked --quiet
    render monolith "$work/hand.png"
}

differ() { # A B
    ! "$program" compare "$1" "$2" --tolerance 5e-3 >/dev/null
}

fail() {
    echo "tests/flexibility/run.sh: $*" >&2
    exit 1
}

echo "building what is edited ..." >&2
cargo build --release --locked --quiet
render auto "$work/before.png"

echo "| edit | graph: lines | files | seconds | by hand: lines | files | seconds |"
echo "| --- | ---: | ---: | ---: | ---: | ---: | ---: |"
for edit in oren_nayar texture rainbow; do
    printf '| %s |' "$edit"
    measured "$edit.graph" by_graph
    differ "$work/before.png" "$work/graph.png" || fail "the edit $edit of the graph changes nothing"
    # By hand is found by its graph: that stays as it was.
    git checkout --quiet .
    measured "$edit.hand" by_hand
    printf '\n'
    differ "$work/before.png" "$work/hand.png" || fail "the edit $edit by hand changes nothing"
    differ "$work/graph.png" "$work/hand.png" && fail "the edit $edit is not the same by hand"
    git checkout --quiet .
done
