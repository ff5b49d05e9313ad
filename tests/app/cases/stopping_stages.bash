# SIGTERM and Ctrl-C in every stage of a run over a large raster with large pictures: it ends within five seconds, and
# nothing is half written. Stages are read off the line of progress, hence the terminal.

readonly promised_ms=5000

now_ms() { echo $(($(date +%s%N) / 1000000)); }

# large_shot SPACING_M: all of the raster that ships, with samples so far apart.
large_shot() {
    gdalwarp -q -tr "$1" "$1" -r cubic -ot Float32 "$shipped_dem" dem.tif
    printf 'dem: dem.tif\nvertical_datum: egm96\n' >terrain.yaml
    small_shot
}

# start_on_terminal ARGUMENT...: the program, in the background and with no cache; its process id is in the file pid, what
# it says in screen.
start_on_terminal() {
    rm -rf pid cache
    : >screen >stdout
    script -qefc "echo \$\$ >pid; exec '$OVERFLY' $*" screen >/dev/null 2>&1 </dev/null &
    render=$!
}

# Whether it has begun to catch SIGTERM, the 15th bit.
listens() { [[ -s pid ]] && (($((16#$(sed -n 's/^SigCgt:\t//p' "/proc/$(cat pid)/status"))) & 0x4000)); }

says() { grep -aq -- "$1" screen; }

is_writing() { compgen -G 'out/.*.tmp-*' >/dev/null; }

# stopped_when SIGNAL COMMAND...: the run ends in time when the signal comes soon after the command succeeds.
stopped_when() {
    local signal=$1 begin_ms took_ms
    shift
    wait_until 200 "$@"
    sleep "0.0$((RANDOM % 10))"
    begin_ms=$(now_ms)
    kill "-$signal" "$(cat pid)"
    exit_code=0
    wait "$render" || exit_code=$?
    took_ms=$(($(now_ms) - begin_ms))
    printf '%s after %s: %d ms\n' "$signal" "$*" "$took_ms"
    cp screen stderr
    expect_exit 130
    expect says 'stopped; what was finished is complete, and a second run goes on from there'
    expect test "$took_ms" -lt "$promised_ms"
    expect_equal 'hidden files' "$(find . -name '.*.tmp-*')" ''
    [[ ! -d out ]] || expect_clean_folder out
}

case_while_terrain_is_prepared() {
    large_shot 37.5
    start_on_terminal render shot.yaml
    stopped_when INT says 'reading elevation'
    start_on_terminal render shot.yaml
    stopped_when TERM says triangulating
    start_on_terminal render shot.yaml
    stopped_when INT says 'meshing for the flight'
    start_on_terminal render shot.yaml
    stopped_when TERM says 'checking the mesh'
}

case_while_light_is_found_and_a_large_picture_traced() {
    large_shot 75
    sed -i 's/width: 64, height: 36/width: 3840, height: 2160/; s/lines: 1/lines: 64/' shot.yaml
    start_on_terminal render shot.yaml --set mesh.pixel_error=0
    stopped_when INT says sunlight
    start_on_terminal render shot.yaml --set mesh.pixel_error=0
    stopped_when TERM says skylight
    start_on_terminal render shot.yaml --set mesh.pixel_error=0
    stopped_when INT says rendering
}

case_while_files_are_written() {
    small_shot
    sed -i 's/width: 64, height: 36/width: 1280, height: 720/' shot.yaml
    local quick='--tracer discrete --samples 1 --set shutter.angle_deg=0'
    start_on_terminal render shot.yaml "$quick" --set frames.count=24
    stopped_when TERM is_writing
    rm -r out
    # The sheet may be finished in time: the movie would come next.
    start_on_terminal render shot.yaml "$quick" --set output.contact_sheet=true --set output.movie=true
    stopped_when INT says 'making the contact sheet'
    start_on_terminal render shot.yaml "$quick" --set output.movie=true
    stopped_when TERM is_writing
    start_on_terminal render shot.yaml "$quick" --set output.movie=true
    stopped_when INT says movie
    run render shot.yaml $quick --set output.contact_sheet=true --set output.movie=true
    expect_exit 0
    run verify out
    expect_exit 0
}

# A library that can't be asked to stop: here one that reads a file without an end.
case_while_a_file_keeps_it_waiting() {
    small_shot
    rm dem.tif
    mkfifo dem.tif
    start_on_terminal render shot.yaml
    stopped_when TERM listens
}
