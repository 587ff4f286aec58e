#include "render_core/perception/lab_planes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render_core/perception/independent_loop.hpp"

namespace tedavis::perception {
namespace {

constexpr int kMaxBlock = 1 << kMaxStartLevel;
constexpr std::size_t kLightSteps = 255 * kMaxBlock * kMaxBlock + 1;

float linear_light(double level) {
    const double share = level / 255;
    return static_cast<float>(share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4));
}

float halley_step(float root, float x) {
    const float cube = root * root * root;
    return root * (cube + 2 * x) / (2 * cube + x);
}

/// Cube root of a positive number within two units of the last place, by the same operations on every machine: a guess from the
/// exponent, and two of Halley's steps.
float cube_root(float x) {
    std::int32_t bits = 0;
    std::memcpy(&bits, &x, sizeof(bits));
    bits = static_cast<std::int32_t>(static_cast<float>(bits) * (1.0f / 3)) + 0x2A5137A0;
    float root = 0;
    std::memcpy(&root, &bits, sizeof(root));
    return halley_step(halley_step(root, x), x);
}

/// The formula's f, of a share of the white.
float compressed_share(float share) {
    constexpr float kLinearBelow = 216.0f / 24389, kSlope = 24389.0f / 27 / 116;
    const float root = cube_root(share > kLinearBelow ? share : kLinearBelow);
    const float line = kSlope * share + 16.0f / 116;
    return share > kLinearBelow ? root : line;
}

struct LightRows {
    const float *red, *green, *blue;
};

/// XYZ of the primaries, each row divided by its sum: the white.
void convert_row(const LightRows& light, int width, float* __restrict lightness, float* __restrict a, float* __restrict b) {
    TEDAVIS_INDEPENDENT_LOOP
    for (int i = 0; i < width; ++i) {
        const float red = light.red[i], green = light.green[i], blue = light.blue[i];
        const float x = compressed_share(0.43395633f * red + 0.37621531f * green + 0.18982836f * blue);
        const float y = compressed_share(0.2126729f * red + 0.7151522f * green + 0.0721749f * blue);
        const float z = compressed_share(0.01775657f * red + 0.10946961f * green + 0.87277382f * blue);
        lightness[i] = 1.16f * y - 0.16f;
        a[i] = 5 * (x - y);
        b[i] = 2 * (y - z);
    }
}

}  // namespace

std::size_t LabConversion::bytes(int most_width) {
    const auto width = static_cast<std::size_t>(most_width);
    return kLightSteps * sizeof(float) + kMaxChannels * (width + kMaxBlock) * sizeof(std::uint16_t) +
           kColors * width * sizeof(float) + 3 * 16;
}

bool LabConversion::start(base::Arena& arena, int most_width) {
    const auto width = static_cast<std::size_t>(most_width);
    light_of_ = arena.allocate_array<float>(kLightSteps);
    sums_ = arena.allocate_array<std::uint16_t>(kMaxChannels * (width + kMaxBlock));
    light_ = arena.allocate_array<float>(kColors * width);
    stride_ = width;
    if (light_of_.empty() || sums_.empty() || light_.empty()) return false;
    for (std::size_t n = 0; n < kLightSteps; ++n) light_of_[n] = linear_light(static_cast<double>(n) / (kMaxBlock * kMaxBlock));
    return true;
}

void LabConversion::add_rows(const PictureView& picture, int first, int level) {
    const int in_picture = picture.channels * picture.width;
    std::uint16_t* __restrict sums = sums_.data();
    std::memset(sums, 0, static_cast<std::size_t>(in_picture) * sizeof(std::uint16_t));
    for (int n = 0; n < 1 << level; ++n) {
        const std::uint8_t* __restrict row = picture.row(std::min(first + n, picture.height - 1));
        for (int i = 0; i < in_picture; ++i) sums[i] = static_cast<std::uint16_t>(sums[i] + row[i]);
    }
    const int whole_blocks = picture.channels * (level_side(picture.width, level) << level);
    for (int i = in_picture; i < whole_blocks; ++i) sums[i] = sums[i - picture.channels];
}

void LabConversion::read_light(int channels, int level, int width) {
    const int block = 1 << level, scale = kMaxBlock * kMaxBlock >> 2 * level;
    const std::uint16_t* sums = sums_.data();
    for (int i = 0; i < width; ++i) {
        int red = 0, green = 0, blue = 0;
        for (int n = 0; n < block; ++n, sums += channels) {
            red += sums[0];
            green += sums[1];
            blue += sums[2];
        }
        float* light = light_.data() + i;
        light[0] = light_of_.data()[red * scale];
        light[stride_] = light_of_.data()[green * scale];
        light[2 * stride_] = light_of_.data()[blue * scale];
    }
}

void LabConversion::convert(const PictureView& picture, int level, const LabPlanes& out) {
    for (int y = 0; y < out.lightness.height; ++y) {
        add_rows(picture, y << level, level);
        read_light(picture.channels, level, out.lightness.width);
        convert_row({light_.data(), light_.data() + stride_, light_.data() + 2 * stride_}, out.lightness.width,
                    out.lightness.row(y), out.a.row(y), out.b.row(y));
    }
}

}  // namespace tedavis::perception
