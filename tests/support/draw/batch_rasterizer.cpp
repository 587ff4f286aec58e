#include "tests/support/draw/batch_rasterizer.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::test_support {
namespace {

using draw::QuadVertex;

double texel_at(double u, double v) {
    const draw::FontAtlas& atlas = draw::font_atlas();
    const double x = u * atlas.width - 0.5, y = v * atlas.height - 0.5;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    double sum = 0;
    for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx) {
            const int column = std::clamp(left + dx, 0, atlas.width - 1), row = std::clamp(top + dy, 0, atlas.height - 1);
            const double weight = (dx ? x - left : 1 - (x - left)) * (dy ? y - top : 1 - (y - top));
            sum += weight * atlas.texels[static_cast<std::size_t>(row) * atlas.width + column] / 255.0;
        }
    return sum;
}

double coverage(double u, double v, double extent_x, double extent_y) {
    if (extent_x >= 0) return std::clamp(std::min(extent_x - std::fabs(u), extent_y - std::fabs(v)) + 0.5, 0.0, 1.0);
    return std::clamp((texel_at(u, v) - 0.5) * extent_y - extent_x - 0.5, 0.0, 1.0);
}

double edge(const QuadVertex& a, const QuadVertex& b, double x, double y) {
    return (static_cast<double>(b.x) - a.x) * (y - a.y) - (static_cast<double>(b.y) - a.y) * (x - a.x);
}

void triangle(const QuadVertex& a, const QuadVertex& b, const QuadVertex& c, Picture& picture) {
    const double area = edge(a, b, c.x, c.y);
    if (area == 0) return;
    const int left = std::max(0, static_cast<int>(std::floor(std::min({a.x, b.x, c.x}))));
    const int right = std::min(picture.width - 1, static_cast<int>(std::ceil(std::max({a.x, b.x, c.x}))));
    const int top = std::max(0, static_cast<int>(std::floor(std::min({a.y, b.y, c.y}))));
    const int bottom = std::min(picture.height - 1, static_cast<int>(std::ceil(std::max({a.y, b.y, c.y}))));
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) {
            const double x = column + 0.5, y = row + 0.5;
            const double wa = edge(b, c, x, y) / area, wb = edge(c, a, x, y) / area, wc = edge(a, b, x, y) / area;
            if (wa < 0 || wb < 0 || wc < 0) continue;
            const double u = wa * a.u + wb * b.u + wc * c.u, v = wa * a.v + wb * b.v + wc * c.v;
            const double alpha = coverage(u, v, a.extent_x, a.extent_y) * a.rgba[3] / 255.0;
            std::uint8_t* pixel = &picture.rgb[3 * (static_cast<std::size_t>(row) * picture.width + column)];
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] = static_cast<std::uint8_t>(std::lround(pixel[channel] * (1 - alpha) + a.rgba[channel] * alpha));
        }
}

}  // namespace

Picture::Picture(int w, int h, design::Color background) : width(w), height(h) {
    for (int i = 0; i < w * h; ++i) rgb.insert(rgb.end(), {background.red, background.green, background.blue});
}

design::Color Picture::at(int x, int y) const {
    const std::size_t first = 3 * (static_cast<std::size_t>(y) * width + x);
    return {rgb[first], rgb[first + 1], rgb[first + 2]};
}

void Picture::save(const std::string& path) const {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << width << " " << height << "\n255\n";
    file.write(reinterpret_cast<const char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
}

void rasterize(const draw::QuadBatch& batch, Picture& picture) {
    const auto vertices = batch.vertices();
    const auto indices = batch.indices();
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        triangle(vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]], picture);
}

}  // namespace tedavis::test_support
