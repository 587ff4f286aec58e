# The stages of ./check, sourced by it. Uses its variables: logs, jobs, passed, failed, summary.

held=true

last_stage_held() { $held; }

# stage NAME COMMAND...: runs COMMAND into its own log; a failure is shown, counted and does not stop the others.
stage() {
    local name=$1 log
    log="$logs/${name// /-}.log"
    shift
    printf '%-20s ' "$name"
    local begin=$SECONDS
    if "$@" >"$log" 2>&1 </dev/null; then held=true; else held=false; fi
    record "$name" "$((SECONDS - begin))" "$log"
    if ! $held; then failed=$((failed + 1)); fi
}

# test_stage NAME RUNNER ARGUMENT...: like stage; the runner ends with the line "held H of N", which is added to the sum.
test_stage() {
    local name=$1 log held_tests=0 all=0
    log="$logs/${name// /-}.log"
    shift
    printf '%-20s ' "$name"
    local begin=$SECONDS
    if "$@" >"$log" 2>&1 </dev/null; then held=true; else held=false; fi
    read -r held_tests all <<<"$(sed -nE 's/^held ([0-9]+) of ([0-9]+)$/\1 \2/p' "$log" | tail -n 1)"
    if [ "${all:-0}" -eq 0 ]; then held=false; fi
    # A runner that failed without a failed test counts as one.
    if ! $held && [ "${held_tests:-0}" -eq "${all:-0}" ]; then all=$((${all:-0} + 1)); fi
    passed=$((passed + ${held_tests:-0}))
    failed=$((failed + all - ${held_tests:-0}))
    record "$name" "$((SECONDS - begin))" "$log" "${held_tests:-0} of $all"
}

# record NAME SECONDS LOG [REMARK]: one line of the summary; the end of the log where the stage failed.
record() {
    local state=ok
    if ! $held; then state=FAILED; fi
    local remark=${4:-$(sed -n 's/^remark: //p' "$3" | tail -n 1)}
    printf '%-7s %5s s  %s\n' "$state" "$2" "$remark"
    summary+=("$(printf '%-20s %-7s %5s s  %s' "$1" "$state" "$2" "$remark")")
    if ! $held; then
        echo "---- end of $3"
        tail -n 60 "$3"
        echo "----"
    fi
}

print_summary() {
    echo
    printf '%s\n' "${summary[@]}"
    grep -h -m 1 '^-- Label real' "$logs/host-build.log" 2>/dev/null
    echo "whole run: $SECONDS s"
    echo
    echo "$passed passed, $failed failed"
}

# run_tests FOLDER EXCLUDED_LABELS (a regular expression): every test of a build folder in a process of its own.
run_tests() {
    # Targets that a preset leaves out appear as <target>_NOT_BUILT.
    local arguments=(--test-dir "$1" -j "$jobs" --output-on-failure --no-tests=error -E '_NOT_BUILT$' -LE "$2") output
    output=$(mktemp)
    ctest "${arguments[@]}" | tee "$output"
    local status=${PIPESTATUS[0]}
    # "97% tests passed, 3 tests failed out of 100"
    sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$output" |
        awk 'END { printf "held %d of %d\n", $2 - $1, $2 }'
    rm -f "$output"
    return "$status"
}

# run_programs PRESET PATTERN: the matching test programs, each in one process: their fixtures are slow under sanitizers.
run_programs() {
    local outputs status
    outputs=$(mktemp -d)
    test_targets "build/$1" "$2" |
        xargs -I NAME -P "$jobs" bash -c "timeout 900 build/$1/bin/NAME --gtest_brief=1 >$outputs/NAME 2>&1 || echo \"ended with \$?\" >>$outputs/NAME"
    cat "$outputs"/*
    # "[==========] 83 tests from 21 test suites ran.", "[  PASSED  ] 83 tests.", and "ended with 134" where it did not hold
    awk '/^\[==========\] .* ran\./ { all += $2 } /^\[  PASSED  \]/ { held += $4 } /^ended with/ { ended++ }
         END { printf "held %d of %d\n", held, all; exit ended > 0 }' "$outputs"/*
    status=$?
    rm -rf "$outputs"
    return "$status"
}

# Names of the test programs of a configured build folder that match the extended regular expression.
test_targets() { cmake --build "$1" --target help | sed -nE 's/^(test_[a-z0-9_]+): phony$/\1/p' | grep -E "$2"; }

build_host() { cmake --preset host && cmake --build build/host -j "$jobs"; }

# build_targets PRESET PATTERN: configures the preset and builds its matching test programs.
build_targets() {
    local targets
    cmake --preset "$1" || return 1
    mapfile -t targets < <(test_targets "build/$1" "$2")
    if [ ${#targets[@]} -eq 0 ]; then
        echo "no test program matches $2"
        return 1
    fi
    cmake --build "build/$1" -j "$jobs" --target "${targets[@]}"
}

build_cross() {
    toolchains/make_sysroot "$1" && cmake --preset "$1" && cmake --build "build/$1" -j "$jobs" || return 1
    if [ -f target/main.cpp ] && [ ! -x "build/$1/bin/tedavis-display" ]; then
        echo "build/$1/bin/tedavis-display was not built although target/main.cpp exists"
        return 1
    fi
}

self_test_cross() {
    local emulator=qemu-aarch64-static driver=llvmpipe
    # Under 32-bit emulation llvmpipe's own code draws wrong colours (Mesa 22.3.6); softpipe has no code generator.
    if [ "$1" = armhf ]; then emulator=qemu-arm-static driver=softpipe; fi
    GALLIUM_DRIVER=$driver timeout 300 "$emulator" -L "build/sysroots/$1" "build/$1/bin/tedavis-display" --self-test
}

# C++ files that differ from the commit before this one (TEDAVIS_CHECK_BASE names another), or all.
changed_sources() {
    local base=${TEDAVIS_CHECK_BASE:-HEAD~1}
    if [ "${1:-}" = true ] || ! git rev-parse -q --verify "$base" >/dev/null; then
        git ls-files '*.cpp' '*.hpp'
    else
        git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp'
    fi
}

check_layout() {
    local files
    mapfile -t files < <(git ls-files '*.cpp' '*.hpp')
    echo "remark: ${#files[@]} files"
    clang-format --dry-run -Werror "${files[@]}" || {
        echo "lay the files out with toolchains/format_sources"
        return 1
    }
}

# check_tidy FULL: the changed sources that the host build compiles, at most 12 unless FULL is true.
check_tidy() {
    local files
    mapfile -t files < <(changed_sources "$1" | grep '\.cpp$' | grep -xF -f <(compiled_sources))
    local all=${#files[@]}
    if [ "$1" != true ]; then files=("${files[@]:0:12}"); fi
    echo "remark: ${#files[@]} of $all changed sources"
    [ ${#files[@]} -eq 0 ] || printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$jobs" timeout 300 clang-tidy -p build/host --quiet
}

compiled_sources() { sed -nE "s|^ *\"file\": \"$PWD/(.*)\",?$|\1|p" build/host/compile_commands.json; }
