# output.compression: what it does to the files, and overfly bench write.

compressions() { exrheader "$1" | sed -n 's/^compression (type compression): \([a-z]*\).*/\1/p' | paste -sd,; }

case_one_word_for_all_layers() {
    small_shot
    run render shot.yaml --frames 1 --set output.compression=piz
    expect_exit 0
    expect_equal 'compression' "$(compressions out/shot.0001.exr)" piz
    expect_clean_folder out
}

case_lossy_colours_beside_depths_without_loss() {
    small_shot
    run render shot.yaml --frames 1
    mv out exact
    run render shot.yaml --frames 1 --set output.compression=dwaa
    expect_exit 0
    expect_equal 'compressions' "$(compressions out/shot.0001.exr)" dwa,zip
    oiiotool exact/shot.0001.exr --ch Z out/shot.0001.exr --subimage data --diff >diff || fail 'depths differ'
    ! oiiotool exact/shot.0001.exr --ch R,G,B out/shot.0001.exr --subimage beauty --ch R,G,B --diff >diff 2>&1 ||
        fail 'colours do not differ'
    expect oiiotool exact/shot.0001.exr --ch R,G,B out/shot.0001.exr --subimage beauty --ch R,G,B --fail 0.03 --diff
    expect_clean_folder out
}

case_frames_are_kept_where_nothing_is_lost() {
    small_shot
    run render shot.yaml
    run render shot.yaml --set output.compression=zips --json
    expect_equal 'rendered' "$(json /frames/rendered)" 0
    run render shot.yaml --set output.compression=dwaa --json
    expect_equal 'rendered' "$(json /frames/rendered)" 6
    run render shot.yaml --set output.compression.beauty=dwaa --set output.compression.quality=60 --json
    expect_equal 'rendered' "$(json /frames/rendered)" 6
    run render shot.yaml --json
    expect_equal 'rendered' "$(json /frames/rendered)" 6
}

case_bench_of_frames() {
    small_shot
    run render shot.yaml --frames 1-2
    run bench write out/shot.0001.exr out/shot.0002.exr --runs 1
    expect_exit 0
    expect_match stdout '^64 x 36, 2 frames, one thread; each frame on average$'
    expect_match stdout '^beauty  dwaa 45 +[0-9.]+ +[0-9]+ % +[0-9.]+ +[0-9.]+ +0[.][0-9]{5}$'
    expect_match stdout '^data    piz +[0-9.]+ +[0-9]+ % +[0-9.]+ +[0-9.]+ +lossless$'
    expect_match stdout '^writing a frame with zip takes [0-9.]+ ms, compression alone [0-9.]+ ms: [0-9.]+ times as long$'
    expect_match stdout '^take, without loss +output.compression: '
    expect_match stdout '^or, where colours may lose +output.compression: \{beauty: dwaa, data: [a-z]+\}: [0-9.]+ MB$'
}

case_bench_of_a_shot() {
    small_shot
    run bench write shot.yaml
    refused 'shot.yaml: no frames in out; render some first: overfly render shot.yaml'
    run render shot.yaml
    run bench write shot.yaml --runs 1 --json
    expect_exit 0
    expect_empty stderr
    expect_equal 'frames' "$(json /frames)" 4
    expect_equal 'raw bytes of the beauty' "$(json /beauty_bytes)" 18432.0
    expect_equal 'raw bytes of the data' "$(json /data_bytes)" 9216.0
    expect_equal 'candidates' "$(json /costs/7/compression)" piz
    expect_equal 'what is lossless' "$(json /costs/0/rmse)" 0.0
    expect_equal 'what is not' "$(awk -v e="$(json /costs/3/rmse)" 'BEGIN { print (e > 0 && e < 0.02) }')" 1
}

case_bench_of_what_is_no_frame() {
    echo text >a.exr
    run bench write a.exr
    expect_exit 2
    expect_match stderr '^a.exr: can.t be read as a frame: '
}
