# The output folder goes away, becomes read-only or full while frames are written: one line, exit code 2, nothing half
# written; what is done stays, and the next run ends with what an undisturbed one makes.

# Twelve frames, a piece of the flight for each, with time enough between them for something to happen.
slow_shot() {
    small_shot
    sed -i 's/count: 6/count: 12, rate: 6/; s/lines: 1/lines: 24/' shot.yaml
    sed -i 's/time_s: 1,/time_s: 2,/' flight.yaml
}

undisturbed() {
    run render shot.yaml
    expect_exit 0
    mv out undisturbed
}

# Root passes over permissions by a capability; without it, root is as any user.
as_any_user() {
    if [[ $(id -u) == 0 ]]; then setpriv --bounding-set=-all --inh-caps=-all -- "$@"; else "$@"; fi
}

start_render() {
    as_any_user "$OVERFLY" render shot.yaml --quiet >stdout 2>stderr &
    render=$!
    wait_until 100 has_frames
}

has_frames() { compgen -G 'out/*.exr' >/dev/null; }

wait_for_render() {
    exit_code=0
    wait "$render" || exit_code=$?
}

# Where a file can't be written as for PATTERN; the file is a frame or the manifest that lists them.
expect_refused() {  # expect_refused PATTERN
    expect_exit 2
    expect_match stderr "^out/(shot[.]00(0[1-9]|1[0-2])[.]exr|manifest[.]json): can't be written: $1$"
    refused "$(head -1 stderr)"
}

expect_frames_kept() {
    local frame complete
    complete=$(find out -name 'shot.*.exr' | wc -l)
    expect test "$complete" -gt 0
    expect test "$complete" -lt 12
    for frame in out/*.exr; do expect cmp "$frame" "undisturbed/${frame#out/}"; done
    run render shot.yaml --json
    expect_exit 0
    expect_equal 'kept' "$(json /frames/kept)" "$complete"
}

expect_as_undisturbed() {
    local frame
    expect_equal 'files' "$(ls -A out)" "$(ls -A undisturbed)"
    for frame in undisturbed/*.exr; do expect cmp "$frame" "out/${frame#undisturbed/}"; done
    run verify out
    expect_exit 0
}

case_folder_is_deleted() {
    slow_shot
    undisturbed
    start_render
    # A file may be made in the folder while it is emptied.
    until rm -r out 2>/dev/null || [[ ! -e out ]]; do :; done
    wait_for_render
    expect_refused 'No such file or directory'
    expect test ! -e out
    run render shot.yaml
    expect_exit 0
    expect_as_undisturbed
}

case_folder_becomes_read_only() {
    slow_shot
    undisturbed
    start_render
    chmod a-w out
    wait_for_render
    chmod u+w out
    expect_refused 'Permission denied'
    # A file that was being written when the folder became read-only can't be taken away: the next run does it.
    expect test "$(find out -name '.*.tmp-*' | wc -l)" -le 1
    expect_frames_kept
    expect_as_undisturbed
}

case_folder_is_read_only_from_the_start() {
    small_shot
    mkdir out
    chmod a-w out
    exit_code=0
    as_any_user "$OVERFLY" render shot.yaml --quiet >stdout 2>stderr || exit_code=$?
    chmod u+w out
    expect_match stderr "^out/shot[.]000[1-6][.]exr: can't be written: Permission denied$"
    refused "$(head -1 stderr)"
    expect_equal 'files' "$(ls -A out)" ''
}

# A file system of its own, which only this process and its children see, and which goes away with them.
in_own_mounts() { unshare --mount --map-root-user "$@" 2>/dev/null; }

can_mount() { in_own_mounts mount -t tmpfs -o size=64k tmpfs .; }

# render_on_small_disk KB: leaves in `out` what was written.
render_on_small_disk() {
    mkdir small out
    exit_code=0
    # What is kept is copied by the shell within, as nobody else sees the small disk.
    in_own_mounts bash -c "mount -t tmpfs -o size=$1k tmpfs small
        \"\$OVERFLY\" render shot.yaml --quiet -o small >stdout 2>messages; code=\$?
        cp -a small/. out; exit \$code" || exit_code=$?
    sed 's/^small/out/' messages >stderr
}

# Where nothing may be mounted, files that may not grow: the first frames are there already, the next are the first
# that don't fit.
render_with_small_files() {
    run render shot.yaml --frames 1-4
    exit_code=0
    (ulimit -f 4 && exec "$OVERFLY" render shot.yaml --quiet) >stdout 2>stderr || exit_code=$?
}

case_disk_becomes_full() {
    slow_shot
    undisturbed
    if can_mount; then
        local frame_kb
        frame_kb=$(($(stat -c %s undisturbed/shot.0001.exr) / 1024))
        render_on_small_disk $((frame_kb * 6))
        expect_refused 'No space left on device'
    else
        render_with_small_files
        expect_refused 'File too large'
    fi
    expect_clean_folder out
    expect_frames_kept
    expect_as_undisturbed
}
