# overfly bench hybrid: the hybrid beside the two tracers that it chooses from.

case_three_tracers_on_one_shot() {
    small_shot
    run bench hybrid shot.yaml --set sampling.tracer=hybrid --set sampling.samples=16 --json
    expect_exit 0
    expect_empty stderr
    expect_equal 'lines' "$(json /lines)" 1
    expect_equal 'samples' "$(json /samples)" 16
    expect_equal 'reference' "$(json /reference_samples)" 1024
    expect_equal 'share of tiles' "$(awk -v s="$(json /share_by_lines)" 'BEGIN { print (s >= 0 && s <= 1) }')" 1
    local tracer
    for tracer in interval discrete hybrid; do
        expect_equal "$tracer, time" "$(awk "BEGIN { print ($(json /tracers/$tracer/ns_per_pixel_frame) > 0) }")" 1
        expect_equal "$tracer, error" "$(awk "BEGIN { print ($(json /tracers/$tracer/rmse) < 0.05) }")" 1
    done
}

# Where one of the two is out of the question, the hybrid makes the picture of the other.
case_the_choice_follows_the_numbers() {
    small_shot
    run bench hybrid shot.yaml --set sampling.samples=4096 --set image.width=16 --set image.height=9 --json
    expect_equal 'by lines' "$(json /share_by_lines)" 1.0
    expect_equal 'error' "$(json /tracers/hybrid/rmse)" "$(json /tracers/interval/rmse)"
    run bench hybrid shot.yaml --set sampling.lines=16 --set sampling.samples=1 --json
    expect_equal 'by lines' "$(json /share_by_lines)" 0.0
    expect_equal 'error' "$(json /tracers/hybrid/rmse)" "$(json /tracers/discrete/rmse)"
}

case_a_table_for_people() {
    small_shot
    run bench hybrid shot.yaml --set sampling.samples=16
    expect_exit 0
    expect_match stdout '^64 x 36, [0-9]+ frames, 1 lines or 16 samples a pixel, one thread; error against 1024 samples$'
    expect_match stdout '^hybrid  +[0-9]+ +0[.][0-9]{5}$'
    expect_match stdout '^the hybrid follows lines in [0-9.]+ % of tiles$'
}
