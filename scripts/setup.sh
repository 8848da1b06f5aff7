#!/bin/sh
# Set up .venv with what running (runtime) or developing (dev) Rolamento, building its
# documentation (docs), or trying its app in a browser (browser), needs.
#
# In plain sh, because the first thing to find out is whether there is a usable Python.
# Does nothing if what it would install is already there. PYTHON chooses an interpreter.
set -eu

cd "$(dirname "$0")/.."
venv=.venv
log=$venv/install.log

fail() {
    echo "rolamento: $1" >&2
    exit 1
}

case "${1:-}" in
    runtime) what="." how="" ;;
    # bytecode is made of what is imported: of all packages it takes a minute
    dev | docs) what=".[$1]" how="--no-compile" ;;
    browser) what=".[browser,dev]" how="--no-compile" ;;
    *) fail "usage: sh scripts/setup.sh runtime|dev|docs|browser" ;;
esac

# From which description the environment was made.
stamp=$(cat pyproject.toml reproductions/pyproject.toml constraints.txt scripts/setup.sh | cksum)

if [ -n "${PYTHON:-}" ]; then
    set -- "$1" "$PYTHON"
else
    set -- "$1" python3.14 python3.13 python3.12 python3.11 python3 python
fi
target=$1
shift

installed() {
    in_place && [ "$(cat "$venv/$1.stamp" 2>/dev/null)" = "$stamp" ]
}

# The scripts of a virtual environment name its place and do not work in another.
in_place() {
    [ -x "$venv/bin/python" ] && [ "$(cat "$venv/place" 2>/dev/null)" = "$(pwd)" ]
}

recent_enough() {
    "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1
}

can_make_environments() {
    "$1" -c 'import venv, ensurepip' >/dev/null 2>&1
}

# Print the first usable interpreter, or else one that lacks only the venv module.
find_python() {
    incomplete=""
    for candidate in "$@"; do
        command -v "$candidate" >/dev/null 2>&1 || continue
        recent_enough "$candidate" || continue
        if can_make_environments "$candidate"; then
            echo "$candidate"
            return
        fi
        [ -n "$incomplete" ] || incomplete=$candidate
    done
    echo "$incomplete"
}

version_of() {
    "$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null || echo "not usable"
}

missing_python() {
    for candidate in "$@"; do
        if command -v "$candidate" >/dev/null 2>&1; then
            fail "Python 3.11 or later is needed, and $candidate is $(version_of "$candidate"); \
install a newer one, or name one with PYTHON=/path/to/python3."
        fi
    done
    fail "Python 3.11 or later is needed, and ${PYTHON:-python3} was not found."
}

make_environment() {
    python=$(find_python "$@")
    [ -n "$python" ] || missing_python "$@"
    can_make_environments "$python" \
        || fail "$python lacks the venv module; install it (on Debian and Ubuntu: \
sudo apt install python$(version_of "$python")-venv)."
    echo "Setting up $venv with $("$python" --version) …"
    "$python" -m venv --clear "$venv" || fail "could not make the virtual environment $venv."
    pwd >"$venv/place"
}

if installed "$target"; then
    exit 0
fi
if ! in_place || ! recent_enough "$venv/bin/python"; then
    make_environment "$@"
fi
echo "Installing Rolamento and what it needs (a minute or two, once) …"
"$venv/bin/python" -m pip install --disable-pip-version-check --quiet $how \
    --constraint constraints.txt --editable "$what" --editable ./reproductions >"$log" 2>&1 \
    || fail "the installation failed (the whole story is in $log); it needs the network, \
or a package index that pip is set up for."
echo "$stamp" >"$venv/$target.stamp"
# Each includes running.
[ "$target" = runtime ] || echo "$stamp" >"$venv/runtime.stamp"
