# Shared by the scripts: packages, and the build. Sourced by bash, with the project as the working
# folder. Messages go to standard error, since standard output belongs to the program.

play_packages=(g++ cmake ninja-build pkg-config libncurses-dev libfmt-dev libcli11-dev)
test_packages=(doctest-dev libgmp-dev libvterm-dev ncurses-term openssh-server openssh-client
    dpkg-dev file)

# ctest runs as many test programs at once as there are cores.
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

say() { printf '%s\n' "$*" >&2; }

fail() {
    say "error: $*"
    exit 2
}

# help_if_asked ARGUMENT...: prints the comment at the top of the script, and ends it, if -h or --help
# comes first.
help_if_asked() {
    case ${1:-} in
        -h | --help) sed -n '2,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$0"; exit 0 ;;
    esac
}

# is_installed PACKAGE: whether the Debian package is installed.
is_installed() {
    [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# need_packages PACKAGE...: installs missing Debian packages. Other systems name packages differently:
# there it only checks for the basic tools, and the build reports what else is missing.
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

# CMake's generator for a new build folder.
generator() {
    if command -v ninja >/dev/null; then echo Ninja; else echo "Unix Makefiles"; fi
}

# configure PRESET FOLDER [cmake arguments]: does nothing if it was last called with the same
# arguments; the build itself reacts to a changed CMakeLists.txt.
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

# build FOLDER [TARGET...]: builds all targets if none is named.
build() {
    local folder=$1 targets=()
    shift
    [ $# -eq 0 ] || targets=(--target "$@")
    cmake --build "$folder" --parallel "$(nproc)" "${targets[@]}" >&2 ||
        fail "the build in $folder failed"
}

# Adds the programs of benchmarks/ to build/release, the build of players and tests. Arguments go to
# cmake.
configure_benchmarks() {
    # Tests need more packages. A folder configured with tests keeps them.
    [ -f build/release/.configured ] || configure release build/release -DCAROM_TESTS=OFF
    cmake -DCAROM_BENCHMARKS=ON "$@" build/release >build/release/configure.log 2>&1 || {
        cat build/release/configure.log >&2
        fail "the build in build/release could not be configured"
    }
}
