# What the scripts share: the packages, and the build. Sourced by bash, with the project as the
# working folder. Everything that is said goes to standard error: standard output is the program's.

play_packages=(g++ cmake ninja-build pkg-config libncurses-dev libfmt-dev libcli11-dev)
test_packages=(doctest-dev libgmp-dev libvterm-dev ncurses-term openssh-server openssh-client)

# ctest runs as many of the test programs at once as there are cores.
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

say() { printf '%s\n' "$*" >&2; }

fail() {
    say "error: $*"
    exit 2
}

# Whether Debian's package is installed.
is_installed() {
    [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Installs those of Debian's packages that are missing. Elsewhere there is no telling by name, so it
# goes on when the tools are there, and the build tells what else is missing.
need_packages() {
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        local tool
        for tool in c++ cmake pkg-config; do
            command -v "$tool" >/dev/null && continue
            say "This system has no apt-get. Please install what Debian calls:"
            say "  $*"
            fail "there is no $tool"
        done
        return
    fi
    local package missing=() root=()
    for package in "$@"; do
        is_installed "$package" || missing+=("$package")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null ||
            fail "these packages are missing, and there is no sudo to install them: ${missing[*]}"
        root=(sudo)
    fi
    say "Installing with apt-get: ${missing[*]}"
    "${root[@]}" apt-get update -qq >&2
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# The generator for a build folder that has none yet.
generator() {
    if command -v ninja >/dev/null; then echo Ninja; else echo "Unix Makefiles"; fi
}

# configure PRESET FOLDER [cmake arguments]: does nothing where it has been done with the same
# arguments; what a changed CMakeLists.txt needs, the build does itself.
configure() {
    local preset=$1 folder=$2 stamp="$2/.configured"
    shift 2
    [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$*" ] && return
    local fresh=()
    [ -f "$folder/CMakeCache.txt" ] || fresh=(-G "$(generator)")
    say "Configuring $folder"
    mkdir -p "$folder"
    cmake --preset "$preset" -B "$folder" "${fresh[@]}" "$@" >"$folder/configure.log" 2>&1 || {
        cat "$folder/configure.log" >&2
        fail "the build in $folder could not be configured"
    }
    printf '%s' "$*" >"$stamp"
}

# build FOLDER [TARGET...]: all targets where none is named.
build() {
    local folder=$1 targets=()
    shift
    [ $# -eq 0 ] || targets=(--target "$@")
    cmake --build "$folder" --parallel "$(nproc)" "${targets[@]}" >&2 ||
        fail "the build in $folder failed"
}

# The programs of benchmarks/ in build/release, which is the build of players and tests too. Arguments
# go to cmake.
configure_benchmarks() {
    # Tests need more packages; a folder that has them switched on keeps them.
    [ -f build/release/.configured ] || configure release build/release -DCAROM_TESTS=OFF
    cmake -DCAROM_BENCHMARKS=ON "$@" build/release >build/release/configure.log 2>&1 || {
        cat build/release/configure.log >&2
        fail "the build in build/release could not be configured"
    }
}
