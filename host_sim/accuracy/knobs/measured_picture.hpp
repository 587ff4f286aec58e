/// A picture on which the knobs of perception are measured: smooth ground, lines and signs, from random numbers that are the same
/// on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/perception/picture_view.hpp"

namespace tedavis::host_sim {

class MeasuredPicture {
public:
    static constexpr int kWidth = 640, kHeight = 480;

    explicit MeasuredPicture(SeededRandom& numbers);

    [[nodiscard]] perception::PictureView view() const { return perception::packed_picture(pixels_.data(), width_, height_); }
    /// The picture reduced by means of n x n pixels; n divides both sides.
    [[nodiscard]] MeasuredPicture shrunk(int n) const;

private:
    MeasuredPicture(int width, int height);
    [[nodiscard]] std::uint8_t* at(int x, int y) { return pixels_.data() + perception::kColors * (y * width_ + x); }
    [[nodiscard]] const std::uint8_t* at(int x, int y) const { return pixels_.data() + perception::kColors * (y * width_ + x); }
    void add_ground(SeededRandom& numbers);
    void add_sign(SeededRandom& numbers);
    void add_line(SeededRandom& numbers);

    int width_ = 0, height_ = 0;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace tedavis::host_sim
