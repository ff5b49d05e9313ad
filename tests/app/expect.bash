# What a case says of the program: `run` it, then `expect` things. The first expectation that fails ends the case with all
# that the program has said.

exit_code=0

# run ARGUMENT...: the program, with its output in the files stdout and stderr, and exit_code.
run() {
    exit_code=0
    "$OVERFLY" "$@" >stdout 2>stderr || exit_code=$?
}

fail() {
    printf 'FAILED: %s\nexit code %s\n--- standard output\n%s\n--- standard error\n%s\n' "$1" "$exit_code" \
        "$(head -c 4000 stdout)" "$(head -c 4000 stderr)" >&2
    exit 1
}

expect() {  # expect COMMAND...: that it succeeds
    "$@" || fail "$*"
}

expect_equal() {  # expect_equal WHAT GOT WANTED
    [[ $2 == "$3" ]] || fail "$1: got '$2', wanted '$3'"
}

expect_near() {  # expect_near WHAT GOT WANTED TOLERANCE
    awk -v got="$2" -v wanted="$3" -v within="$4" \
        'BEGIN { d = got - wanted; exit !(got != "" && d <= within && -d <= within) }' ||
        fail "$1: got '$2', wanted $3 within $4"
}

expect_exit() { expect_equal 'exit code' "$exit_code" "$1"; }

expect_line() {  # expect_line FILE LINE: the very line is there
    grep -Fxq -- "$2" "$1" || fail "no line '$2' in $1"
}

expect_match() {  # expect_match FILE PATTERN: some line matches
    grep -Eq -- "$2" "$1" || fail "no line like '$2' in $1"
}

expect_no_match() { ! grep -Eq -- "$2" "$1" || fail "a line like '$2' in $1"; }

expect_empty() { [[ ! -s $1 ]] || fail "$1 is not empty"; }

# refused LINE...: what the program said is these lines and nothing else, and it ended as for what a user can mend.
refused() {
    expect_equal 'standard error' "$(cat stderr)" "$(printf '%s\n' "$@")"
    expect_empty stdout
    expect_exit 2
}

# Frames that exist are complete, and no file is left under a temporary name.
expect_clean_folder() {
    local frame
    expect_equal "hidden files in $1" "$(find "$1" -name '.*' ! -name '.' ! -name '..')" ''
    for frame in "$1"/*.exr; do
        [[ ! -e $frame ]] || expect "$OVERFLY_PROBE" complete "$frame"
    done
}

# expect_same_frames A B: pixels equal to the bit
expect_same_frames() { expect "$OVERFLY_PROBE" same "$1" "$2"; }

# json POINTER: the value in the program's output, which has to be JSON as a whole
json() { "$OVERFLY_PROBE" json "$1" <stdout; }

# wait_until SECONDS COMMAND...
wait_until() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        ((SECONDS < end)) || fail "waited in vain until: $*"
        sleep 0.02
    done
}
