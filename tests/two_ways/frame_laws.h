#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "core/parallel.h"
#include "two_ways/blurred_frame.h"

// What holds of frames however they come about.
namespace overfly::testing {

// Sixteen lines against 1,024 samples.
inline void expect_sixteen_lines_suffice(const FrameMaker& make, const std::string& of_what) {
    const Frame reference = make.by_samples(1024);
    const double error = root_mean_square(make.by_lines(16), reference);
    std::cout << "RMSE of 16 lines against 1,024 samples, " << of_what << ": " << error << "\n";
    EXPECT_LT(error, 0.004);
    // Beside it, so that the bound means something: as many samples as lines are worse.
    EXPECT_LT(error, root_mean_square(make.by_samples(16), reference));
}

// Following the visible point gives the picture that asking each line anew gives.
inline void expect_kinetic_lines_to_be_the_interval_tracers(const FrameMaker& make, int lines) {
    EXPECT_LT(root_mean_square(make.by_kinetic_lines(lines), make.by_lines(lines)), 1e-3);
}

// make: exposes one frame.
template <class Make>
void expect_the_same_for_any_number_of_threads(const Make& make) {
    const int before = thread_limit();
    limit_threads(1);
    const Frame one = make();
    limit_threads(2);
    const Frame two = make();
    limit_threads(before);
    EXPECT_TRUE(one == two);
}

// make: exposes some of five frames, the first of which begins at a time: make(asked, all).
template <class Make>
void expect_the_same_whichever_frames_are_asked_for(double begin_s, const Make& make) {
    std::vector<TimeRange> exposures;
    for (int k = 0; k < 5; ++k) exposures.push_back(half_a_frame(begin_s + k / 24.0));
    const std::vector<Frame> all = make(exposures, exposures);
    EXPECT_TRUE(make({exposures[0]}, exposures).front() == all[0]);
    const std::vector<Frame> some = make({exposures[1], exposures[4]}, exposures);
    EXPECT_TRUE(some[0] == all[1]);
    EXPECT_TRUE(some[1] == all[4]);
}

}  // namespace overfly::testing
