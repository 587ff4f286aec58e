#include "host_sim/measure/color_vision.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

constexpr double kNormal[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr double kProtan[3][3] = {
    {0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
constexpr double kDeutan[3][3] = {
    {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
constexpr double kTritan[3][3] = {
    {1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}};

using Matrix = const double (&)[3][3];
Matrix matrix_of(ColorVision vision) {
    switch (vision) {
        case ColorVision::protan: return kProtan;
        case ColorVision::deutan: return kDeutan;
        case ColorVision::tritan: return kTritan;
        case ColorVision::normal: break;
    }
    return kNormal;
}

}  // namespace

const char* to_string(ColorVision vision) noexcept {
    switch (vision) {
        case ColorVision::protan: return "protanopia";
        case ColorVision::deutan: return "deuteranopia";
        case ColorVision::tritan: return "tritanopia";
        case ColorVision::normal: break;
    }
    return "normal vision";
}

design::LinearRgb seen_with(ColorVision vision, const design::LinearRgb& light) noexcept {
    const auto row = [&light](const double(&r)[3]) {
        return std::clamp(r[0] * light.red + r[1] * light.green + r[2] * light.blue, 0.0, 1.0);
    };
    Matrix m = matrix_of(vision);
    return {row(m[0]), row(m[1]), row(m[2])};
}

}  // namespace tedavis::host_sim
