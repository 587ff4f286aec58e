/// A picture that a test painted, for conditions that look at one.
#pragma once

#include <utility>

#include "host_sim/flight_test/shown_picture.hpp"

namespace tedavis::test_support {

class PaintedPicture final : public host_sim::ShownPicture {
public:
    const host_sim::RgbaPicture& pixels() override { return ++times_asked_, picture; }
    const host_sim::LayerMask& layers() override { return mask; }
    const host_sim::FlightFrame& frame() override { return read; }
    [[nodiscard]] int times_asked() const { return times_asked_; }

    host_sim::RgbaPicture picture;
    host_sim::LayerMask mask;
    host_sim::FlightFrame read;

private:
    int times_asked_ = 0;
};

}  // namespace tedavis::test_support
