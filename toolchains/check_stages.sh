# The stages of ./check, sourced by it. Uses its variables: full, joint, logs, jobs, slow_programs, long_suites, passed, failed, summary.

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
    if ! $full; then echo "-- Label real: run by ./check --full"; fi
    echo "whole run: $SECONDS s"
    echo
    echo "$passed passed, $failed failed"
}

# run_programs PRESET PATTERN [EXCEPT]: the matching test programs, each in a few processes of many suites: the fixtures of a suite are
# slow. The slow programs come first and in more parts, so that all processors end at about the same time.
run_programs() {
    local outputs status programs program
    outputs=$(mktemp -d)
    programs=$(test_targets "build/$1" "$2" "${3:-^$}")
    {
        for program in $(grep -E "$slow_programs" <<<"$programs"); do part_suites "build/$1/bin/$program" "$outputs/$program" 4; done
        for program in $(grep -vE "$slow_programs" <<<"$programs"); do part_suites "build/$1/bin/$program" "$outputs/$program" 2; done
    } | xargs -L 1 -P "$jobs" bash -c "run_part build/$1/bin $outputs \$0 \$1"
    cat "$outputs"/*.held "$outputs"/*.failed 2>/dev/null
    # "[==========] 83 tests from 21 test suites ran.", "[  PASSED  ] 83 tests."
    awk '/^\[==========\] .* ran\./ { all += $2 } /^\[  PASSED  \]/ { held += $4 } END { printf "held %d of %d\n", held, all }' "$outputs"/*
    [ -z "$(find "$outputs" -name '*.failed')" ]
    status=$?
    rm -rf "$outputs"
    return "$status"
}

# part_suites PROGRAM FILES PARTS: deals the suites of a test program to so many files FILES.N.suites, each a filter of GoogleTest, and
# prints a line "NAME N" for each file. A program that cannot say its suites is one part: it will fail.
part_suites() {
    "$1" --gtest_list_tests 2>/dev/null | sed -nE 's/^([^ ]+\.)( .*)?$/\1*/p' | grep -vE "$long_suites" |
        awk -v files="$2" -v parts="$3" '{ printf "%s:", $0 > (files "." (NR - 1) % parts ".suites") }'
    if [ ! -e "$2.0.suites" ]; then printf '*' >"$2.0.suites"; fi
    local part
    for part in "$2".*.suites; do
        part=${part%.suites}
        echo "${1##*/} ${part##*.}"
    done
}

# run_part FOLDER OUTPUTS PROGRAM PART: the suites of a program that stand in the part's file.
# LeakSanitizer looks for leaks from a second process when all tests are done, and that one now and then crashes over threads of
# the GL driver that are just ending: then nothing is known of leaks, and the part is run once more.
run_part() {
    local output=$2/$3.$4 status=0
    test_part "$@" || status=$?
    if [ "$status" -ne 0 ] && grep -q "LeakSanitizer has encountered a fatal error" "$output"; then
        status=0
        test_part "$@" || status=$?
    fi
    if [ "$status" -eq 0 ]; then
        mv "$output" "$output.held"
    else
        echo "$3, part $4: ended with $status" >>"$output"
        mv "$output" "$output.failed"
    fi
}
test_part() { timeout 900 "$1/$3" --gtest_brief=1 --gtest_filter="$(<"$2/$3.$4.suites")" >"$2/$3.$4" 2>&1; }

# test_targets FOLDER PATTERN [EXCEPT]: names of test programs of a configured build folder, by extended regular expressions.
test_targets() {
    cmake --build "$1" --target help | sed -nE 's/^(test_[a-z0-9_]+): phony$/\1/p' | grep -E "$2" | grep -vE "${3:-^$}"
}

# build_targets PRESET PATTERN [EXCEPT [TARGET...]]: configures the preset and builds its matching test programs, and the targets.
build_targets() {
    local targets
    # Each source alone proves that it includes what it needs.
    cmake --preset "$1" -DTEDAVIS_JOINT="$joint" || return 1
    mapfile -t targets < <(test_targets "build/$1" "$2" "${3:-^$}")
    if [ ${#targets[@]} -eq 0 ]; then
        echo "no test program matches $2"
        return 1
    fi
    cmake --build "build/$1" -j "$jobs" --target "${targets[@]}" "${@:4}"
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

# changed_sources FULL COMPILED: sources to read, of those listed in the file COMPILED: all of them with FULL; else those that the last
# 60 commits changed, and for each changed header one that includes it, the newest first.
changed_sources() {
    if [ "$1" = true ]; then
        cat "$2"
        return
    fi
    { git diff --name-only HEAD; git log -60 --format= --name-only; } 2>/dev/null | awk '/\.[ch]pp$/ && !seen[$0]++' |
        while read -r file; do
            if [ "${file%.hpp}" = "$file" ]; then
                echo "$file"
            elif grep -qxF "${file%.hpp}.cpp" "$2"; then
                echo "${file%.hpp}.cpp"
            else
                xargs grep -lF "#include \"$file\"" <"$2" 2>/dev/null | head -n 1
            fi
        done | awk '!seen[$0]++' | grep -xF -f "$2"
}

check_layout() {
    local files
    mapfile -t files < <(git ls-files '*.cpp' '*.hpp')
    echo "remark: ${#files[@]} files"
    clang-format --dry-run -Werror "${files[@]}" || {
        echo "lay the files out with toolchains/format_sources"
        return 1
    }
    tests/flight_tests/seeded_faults --check  # each fault still has its place in the sources
}

# check_tidy FULL: the changed sources that the host build compiles, at most 40 unless FULL is true. Of a function that branches much the
# analyzer then walks the first 40,000 steps, and not 225,000: half of the time goes into the last steps of a few functions.
check_tidy() {
    local files compiled most=40
    analyzer_steps=40000
    if [ "$1" = true ]; then analyzer_steps=225000; fi
    export analyzer_steps
    compiled=$(mktemp)
    compiled_sources | sort -u | while read -r file; do [ ! -f "$file" ] || echo "$file"; done >"$compiled"
    mapfile -t files < <(changed_sources "$1" "$compiled")
    rm -f "$compiled"
    local all=${#files[@]}
    if [ "$1" != true ]; then files=("${files[@]:0:$most}"); fi
    echo "remark: ${#files[@]} of $all changed sources"
    export -f tidy_source
    [ ${#files[@]} -eq 0 ] || printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$jobs" bash -c 'tidy_source "$0"'
}

# Tests are compiled several at a time, by a source that includes them: its command is theirs.
compiled_sources() {
    sed -nE "s|^ *\"file\": \"$PWD/(.*)\",?$|\1|p" build/host/compile_commands.json
    find build/host -path '*/Unity/*.cxx' -exec sed -nE "s|^#include \"$PWD/(.*)\"$|\1|p" {} +
}

# tidy_source FILE: clang-tidy with the options that the host build compiles it with.
tidy_source() {
    local joint options steps=(-Xclang -analyzer-config -Xclang "max-nodes=$analyzer_steps")
    joint=$(grep -rlF --include='*.cxx' "\"$PWD/$1\"" build/host | head -n 1)
    if [ -z "$joint" ]; then timeout 600 clang-tidy -p build/host --quiet "${steps[@]/#/--extra-arg=}" "$1"; return; fi
    options=$(sed -nE "s|^ *\"command\": \"(.*) -o [^ ]* -c $PWD/$joint\",?$|\1|p" build/host/compile_commands.json)
    eval "options=(${options//\\\\/})"  # one level of escapes is JSON's
    timeout 600 clang-tidy --quiet "$1" -- "${options[@]:1}" "${steps[@]}"
}
