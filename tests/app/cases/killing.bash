# kill -9 fifty times, at moments all over a run: what has its final name is whole each time, and in the end all is as if
# nothing had happened.

now_ms() { echo $(($(date +%s%N) / 1000000)); }

sleep_ms() { sleep "$(printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)))"; }

# A piece of the flight for each frame, so that frames are finished one after another.
killable_shot() {
    small_shot
    sed -i 's/count: 6/count: 6, rate: 6/; s/lines: 1/lines: 4/; s/contact_sheet: false, movie: false/contact_sheet: true, movie: true/' \
        shot.yaml
}

is_writing() { compgen -G 'out/.*.tmp-*' >/dev/null; }

# killed_after WAIT...: a run that is killed once WAIT has ended; false if it has ended before, as it should.
killed_after() {
    "$OVERFLY" render shot.yaml >stdout 2>stderr &
    local render=$!
    "$@"
    kill -KILL "$render" 2>/dev/null || true
    exit_code=0
    wait "$render" 2>/dev/null || exit_code=$?
    ((exit_code == 137)) && return 0
    expect_exit 0
    return 1
}

# Waits for a file that is being written, and up to 10 ms more. Not for ever: the run may have nothing to write.
a_file_is_begun() {
    local end=$((SECONDS + 3))
    until is_writing || ((SECONDS > end)); do :; done
    sleep_ms $((RANDOM % 10))
}

# The pixels of all frames are those that the manifest lists. All that may be amiss: frames are missing, or the run was
# killed between a frame and the manifest that lists it.
expect_sound_so_far() {
    local frames=()
    # The first frames may be there before it is.
    [[ ! -e out/manifest.json ]] || {
        run verify out --json
        expect_no_match stdout '"fault": "(m[^i]|u[^n]|[^mu])'
        expect_no_match stdout '"manifest": false'
        expect_equal 'other faults' "$(grep -Ev ': (missing|the manifest does not list it)$' stderr)" ''
    }
    mapfile -t frames < <(find out -name 'shot.*.exr' 2>/dev/null)
    ((${#frames[@]} == 0)) || expect "$OVERFLY_PROBE" complete "${frames[@]}"
    [[ ! -e out/manifest.json ]] || expect "$OVERFLY_PROBE" json /format <out/manifest.json >/dev/null
}

# The manifest but for how long frames took.
timeless() { sed '/"render_s"/d' "$1/manifest.json"; }

expect_as_undisturbed() {
    local file
    expect_equal 'files' "$(ls -A out)" "$(ls -A undisturbed)"
    expect_equal 'manifest' "$(timeless out)" "$(timeless undisturbed)"
    for file in undisturbed/*.exr undisturbed/*.png undisturbed/*.mp4; do
        expect cmp "$file" "out/${file#undisturbed/}"
    done
    expect_equal 'hidden files in the cache' "$(find cache -name '.*')" ''
}

# How far the run had come that was killed last, by what is there.
stage_of_kill() {
    local frames
    frames=$(find out -name 'shot.*.exr' 2>/dev/null | wc -l)
    if ((frames == 0)); then echo before; elif ((frames < 6)); then echo among; else echo after; fi
}

# As it is after a run that got to its end; then all of it goes.
begin_anew() {
    expect_as_undisturbed
    rm -r out cache
}

# kill_within MS: a run, after so long; one that is quicker than that is run anew from nothing.
kill_within() {
    local moment_ms=$1 anew=no
    until killed_after sleep_ms "$moment_ms"; do
        begin_anew
        [[ $anew == no ]] || moment_ms=$((moment_ms * 3 / 4))
        anew=yes
    done
}

# Half of the frames and the previews, so that the next run has something of everything to do.
lose_some() {
    local number
    for number in 1 3 4; do rm -f out/shot.000$(((number + RANDOM) % 6 + 1)).exr; done
    rm -f out/shot.mp4 out/shot.contact.png
}

kill_while_writing() {
    until killed_after a_file_is_begun; do begin_anew; done
}

# ten_kills PART: five at moments spread over the length of a run, in an order that mixes early and late, and between
# them five while a file is written. Each run goes on where the last was killed, with something to do.
ten_kills() {
    local -r seed=$((20261122 + $1))
    RANDOM=$seed
    printf 'seed %d\n' "$seed"
    killable_shot
    local begin_ms whole_ms fifth stages=
    begin_ms=$(now_ms)
    run render shot.yaml
    expect_exit 0
    whole_ms=$(($(now_ms) - begin_ms))
    mv out undisturbed
    rm -r cache
    for fifth in 0 3 1 4 2; do
        lose_some
        kill_within $((whole_ms * (1000 * fifth + RANDOM % 1000) / 5000))
        stages+="$(stage_of_kill) "
        expect_sound_so_far
        lose_some
        kill_while_writing
        stages+="$(stage_of_kill) "
        expect_sound_so_far
    done
    printf 'killed at %s\n' "$stages"
    run render shot.yaml
    expect_exit 0
    expect_as_undisturbed
    local stage
    for stage in before among after; do expect_match <(echo "$stages") $stage; done
}

case_ten_times() { ten_kills 0; }
case_ten_times_more() { ten_kills 1; }
case_thirty_times() { ten_kills 2; }
case_forty_times() { ten_kills 3; }
case_fifty_times() { ten_kills 4; }
