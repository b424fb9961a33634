# shellcheck shell=bash
# Sourced by packaging/run and packaging/test: packages, configuration, build. Expects `set -eu` and the source root as
# the current folder.

build=build

say() { printf '%s\n' "$*" >&2; }

# missing_packages LIST: those of the packages in the file LIST, one a line, that are not installed.
missing_packages() {
    local wanted
    wanted=$(grep -v '^#' "$1")
    # shellcheck disable=SC2086  # one word a package
    dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' $wanted 2>/dev/null \
        | awk -v wanted="$wanted" '
            $1 == "ii" { have[$2] = 1 }
            END { n = split(wanted, w, "\n"); for (i = 1; i <= n; ++i) if (!(w[i] in have)) print w[i] }'
}

# install_missing [LIST]
install_missing() {
    if ! command -v dpkg-query >/dev/null; then
        say "This is no Debian system: install what packaging/dependencies lists by its names here. Going on."
        return
    fi
    local missing as_root=()
    missing=$(missing_packages "${1:-packaging/dependencies}" | tr '\n' ' ')
    [ -n "$missing" ] || return 0
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null || ! sudo -n true 2>/dev/null; then
            say "Packages are missing and there is no right to install them. Run this line as root, then start again:"
            say "apt-get install --no-install-recommends -y $missing"
            exit 1
        fi
        as_root=(sudo -n)
    fi
    say "Installing: $missing"
    "${as_root[@]}" apt-get update -q >&2 || say "The package lists could not be refreshed; trying those that are there."
    # shellcheck disable=SC2086
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --no-install-recommends -y -q $missing >&2
}

# configure_preset PRESET [OPTION…]: with ccache where it is there, told to keep what precompiled headers went into.
configure_preset() {
    local options=("${@:2}")
    if command -v ccache >/dev/null; then
        local sloppiness=pch_defines,time_macros,include_file_mtime,include_file_ctime
        options+=("-DCMAKE_CXX_COMPILER_LAUNCHER=env;CCACHE_SLOPPINESS=$sloppiness;ccache")
    fi
    cmake --preset "$1" "${options[@]}" >&2
}

# What the CUDA renderer is compiled for: the GPUs of this machine, or, where there is none, code that any driver compiles
# when it is first used. All chips that nvcc knows (no option: the presets) take a minute more of a processor.
gpu_architectures() {
    local found=""
    if command -v nvidia-smi >/dev/null; then
        found=$(nvidia-smi --query-gpu=compute_cap --format=csv,noheader 2>/dev/null | tr -d . | sort -u | sed 's/$/-real/' \
            | paste -sd ';') || found=""
    fi
    printf '%s' "${found:-75-virtual}"
}

# Ninja runs CMake again by itself when a CMake file changes; this is for the first time and for another setting.
configure() {
    local werror=OFF
    [ -z "${CI:-}" ] || werror=ON
    if [ -f $build/build.ninja ] && [ ! CMakePresets.json -nt $build/build.ninja ] \
        && grep -q "^SUFFUSE_WERROR:BOOL=$werror\$" $build/CMakeCache.txt; then
        return
    fi
    configure_preset default "-DSUFFUSE_WERROR=$werror" -DSUFFUSE_UNITY=ON "-DSUFFUSE_CUDA_ARCHITECTURES=$(gpu_architectures)"
}

build_targets() {
    local log=$build/build.log
    say "Building …"
    if [ -t 2 ]; then
        cmake --build $build --target "$@" >&2
    elif ! cmake --build $build --target "$@" >$log 2>&1; then
        cat $log >&2
        return 1
    fi
}
