#include "host_sim/terrain_builder/drape_sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host_sim/quiet_gdal.hpp"
#include "host_sim/terrain_builder/raster_source.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::kDrapePosts;
using terrain::kDrapeSteps;

constexpr double kTexelsPerPost = kDrapeSteps / double{terrain::kChunkCells};
constexpr std::uint32_t kKnot = 16;             // texels between places that others are interpolated from
constexpr double kKnotAccuracy = 0.05;          // pixels; else every place is transformed
constexpr double kNearlyAsFine = 1.01;          // a texel a hundredth larger than a pixel is as fine
constexpr int kProbes = 17;                     // places along each side of terrain and image that look for the other
constexpr double kMove = 1.0 / 64;              // posts
constexpr std::size_t kStripBytes = 4u << 20;   // of pixels read at once
constexpr std::int64_t kMaxBlocks = 1'000'000;  // of a page; only where a map projection tears it apart
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

using Pixel = DrapeSampler::Pixel;

struct PixelBounds {
    double west = 1e300, east = -1e300, north = 1e300, south = -1e300;

    void cut_columns(double first, double last) {
        west = std::max(west, first);
        east = std::min(east, last);
    }
    void cut_rows(double first, double last) {
        north = std::max(north, first);
        south = std::min(south, last);
    }
};

PixelBounds bounds_of(const std::vector<Pixel>& places) {
    PixelBounds bounds;
    for (const Pixel& p : places) {
        if (std::isnan(p.x)) continue;
        bounds.west = std::min(bounds.west, p.x);
        bounds.east = std::max(bounds.east, p.x);
        bounds.north = std::min(bounds.north, p.y);
        bounds.south = std::max(bounds.south, p.y);
    }
    return bounds;
}

/// From places every half knot, those between all knots, if the ones in the middle prove that good enough.
bool interpolate(const std::vector<Pixel>& halves, std::vector<Pixel>& pixels) {
    constexpr std::uint32_t kAcross = 2 * kDrapeSteps / kKnot + 1;
    const auto half = [&](std::uint32_t a, std::uint32_t b) { return halves[std::size_t{b} * kAcross + a]; };
    const auto between = [&](std::uint32_t a, std::uint32_t b, double u, double v) {
        const Pixel nw = half(a, b), ne = half(a + 2, b), sw = half(a, b + 2), se = half(a + 2, b + 2);
        return Pixel{(nw.x * (1 - u) + ne.x * u) * (1 - v) + (sw.x * (1 - u) + se.x * u) * v,
                     (nw.y * (1 - u) + ne.y * u) * (1 - v) + (sw.y * (1 - u) + se.y * u) * v};
    };
    for (std::uint32_t b = 0; b + 2 < kAcross; b += 2)
        for (std::uint32_t a = 0; a + 2 < kAcross; a += 2)
            for (const auto& [x, y] : {std::pair{1u, 0u}, std::pair{0u, 1u}, std::pair{1u, 1u}}) {
                const Pixel p = between(a, b, 0.5 * x, 0.5 * y), known = half(a + x, b + y);
                if (!(std::hypot(p.x - known.x, p.y - known.y) <= kKnotAccuracy)) return false;
            }
    pixels.resize(std::size_t{kDrapePosts} * kDrapePosts);
    for (std::uint32_t b = 0; b < kDrapePosts; ++b)
        for (std::uint32_t a = 0; a < kDrapePosts; ++a) {
            const std::uint32_t k = std::min(a / kKnot, kDrapeSteps / kKnot - 1),
                                l = std::min(b / kKnot, kDrapeSteps / kKnot - 1);
            pixels[std::size_t{b} * kDrapePosts + a] =
                between(2 * k, 2 * l, double(a - k * kKnot) / kKnot, double(b - l * kKnot) / kKnot);
        }
    return true;
}

}  // namespace

/// What one thread needs of the image.
class DrapeSampler::Reader {
public:
    explicit Reader(const DrapeOptions& options) : image(options) {
        OGRSpatialReference wgs84 = wgs84_longitude_latitude();
        if (image.crs().IsSame(&wgs84) == 0) {
            const QuietGdal quiet;
            change_.reset(OGRCreateCoordinateTransformation(&wgs84, &image.crs()));
            if (change_ == nullptr)
                throw UserError(image.file() + ": its coordinate system '" + image.crs().GetName() +
                                "' cannot be reached from longitude and latitude; give another with --drape-crs");
        }
        const double turn = 360 / image.transform()[1];
        if (image.crs().IsGeographic() != 0 && image.transform()[2] == 0) columns_round_ = std::abs(turn);
        const double whole = std::round(columns_round_);
        if (columns_round_ > 0 && std::abs(whole - columns_round_) < 0.01 && image.columns() >= whole)
            goes_round_ = static_cast<int>(whole);
    }

    /// Longitudes and latitudes in degrees to pixels, NaN where there is none.
    void to_pixels(std::vector<double>& x, std::vector<double>& y, std::vector<Pixel>& pixels) const {
        std::vector<int> known(x.size(), 1);
        if (change_ != nullptr) {
            const QuietGdal quiet;
            (void)change_->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, known.data());
        }
        const std::array<double, 6>& t = image.to_pixels();
        pixels.resize(x.size());
        for (std::size_t n = 0; n < x.size(); ++n) {
            const bool usable = known[n] != 0 && std::isfinite(x[n]) && std::isfinite(y[n]);
            pixels[n] = usable ? Pixel{t[0] + t[1] * x[n] + t[2] * y[n], t[3] + t[4] * x[n] + t[5] * y[n]} : Pixel();
        }
        unwrap(pixels);
    }
    /// Pixels to longitudes and latitudes in degrees, in place; infinite where there is none.
    void to_degrees(std::vector<double>& x, std::vector<double>& y) const {
        const std::array<double, 6>& t = image.transform();
        for (std::size_t n = 0; n < x.size(); ++n) {
            const double column = x[n], row = y[n];
            x[n] = t[0] + t[1] * column + t[2] * row;
            y[n] = t[3] + t[4] * column + t[5] * row;
        }
        if (change_ == nullptr) return;
        const QuietGdal quiet;
        const std::unique_ptr<OGRCoordinateTransformation> back(change_->GetInverse());
        std::vector<int> known(x.size(), 0);
        if (back != nullptr) (void)back->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, known.data());
        for (std::size_t n = 0; n < x.size(); ++n)
            if (known[n] == 0) x[n] = y[n] = kNowhere;
    }
    /// Pixels across the whole Earth where that is what the image shows, else 0: column n is column n + goes_round().
    [[nodiscard]] int goes_round() const { return goes_round_; }

    ImageSource image;

private:
    /// The same meridian has many names; the first place takes that nearest to the image, the others those nearest to it.
    void unwrap(std::vector<Pixel>& pixels) const {
        if (columns_round_ == 0) return;
        double near = 0.5 * image.columns();
        for (Pixel& p : pixels) {
            if (std::isnan(p.x)) continue;
            p.x += columns_round_ * std::round((near - p.x) / columns_round_);
            if (&p == pixels.data()) near = p.x;
        }
    }

    std::unique_ptr<OGRCoordinateTransformation> change_;  // none: longitude and latitude are the image's coordinates
    double columns_round_ = 0;
    int goes_round_ = 0;
};

/// Means of blocks of pixels, in a window: RGB times coverage and coverage, 0..255.
struct DrapeSampler::Blocks {
    std::int64_t column = 0, row = 0;
    std::int64_t columns = 0, rows = 0;
    int width = 1, height = 1;  // of a block
    std::vector<std::array<float, 4>> mean;

    /// Those that a page needs; none where it lies beside the image.
    static Blocks needed(const std::vector<Pixel>& places, const Reader& reader, int width, int height) {
        PixelBounds bounds = bounds_of(places);
        if (reader.goes_round() == 0) bounds.cut_columns(-kNearImage * width, reader.image.columns() + kNearImage * width);
        bounds.cut_rows(-kNearImage * height, reader.image.rows() + kNearImage * height);
        Blocks blocks;
        if (!(bounds.west <= bounds.east && bounds.north <= bounds.south)) return blocks;
        for (blocks.width = width, blocks.height = height;; blocks.width *= 2, blocks.height *= 2) {
            const auto first = [](double edge, int size) { return static_cast<std::int64_t>(std::floor(edge / size - 0.5)); };
            blocks.column = first(bounds.west, blocks.width);
            blocks.row = first(bounds.north, blocks.height);
            blocks.columns = first(bounds.east, blocks.width) + 2 - blocks.column;
            blocks.rows = first(bounds.south, blocks.height) + 2 - blocks.row;
            if (blocks.columns * blocks.rows <= kMaxBlocks) break;
        }
        blocks.mean.resize(static_cast<std::size_t>(blocks.columns * blocks.rows));
        return blocks;
    }

    void read(const Reader& reader) {
        const std::int64_t first = column * width, end = (column + columns) * width;
        const int round = reader.goes_round(), across = round != 0 ? round : reader.image.columns();
        for (std::int64_t c = first; c < end;) {
            const std::int64_t inside = round != 0 ? (c % round + round) % round : c;
            const std::int64_t count = inside < 0 ? -inside : inside < across ? across - inside : end - c;
            const std::int64_t next = std::min(end, c + count);
            if (inside >= 0 && inside < across)
                read_columns(reader.image, c, static_cast<int>(inside), static_cast<int>(next - c));
            c = next;
        }
        const float share = 1.0f / (static_cast<float>(width) * static_cast<float>(height));
        for (std::array<float, 4>& m : mean)
            for (float& channel : m) channel *= share;
    }

    /// Bilinear between the blocks' middles.
    [[nodiscard]] std::array<float, 4> at(const Pixel& p) const {
        const double u = p.x / width - 0.5 - static_cast<double>(column), v = p.y / height - 0.5 - static_cast<double>(row);
        if (!(u >= 0 && v >= 0)) return {};
        const auto i = static_cast<std::int64_t>(u), j = static_cast<std::int64_t>(v);
        if (i + 1 >= columns || j + 1 >= rows) return {};
        const auto x = static_cast<float>(u - static_cast<double>(i)), y = static_cast<float>(v - static_cast<double>(j));
        const auto n = static_cast<std::size_t>(j * columns + i), below = n + static_cast<std::size_t>(columns);
        std::array<float, 4> color{};
        for (std::size_t c = 0; c < 4; ++c)
            color[c] =
                (mean[n][c] * (1 - x) + mean[n + 1][c] * x) * (1 - y) + (mean[below][c] * (1 - x) + mean[below + 1][c] * x) * y;
        return color;
    }

private:
    static constexpr int kNearImage = 2;  // blocks round the image in which it fades out

    /// Column `inside` of the image and those after it, counted from `c` here.
    void read_columns(const ImageSource& image, std::int64_t c, int inside, int count) {
        const int top = static_cast<int>(std::clamp<std::int64_t>(row * height, 0, image.rows()));
        const int bottom = static_cast<int>(std::clamp<std::int64_t>((row + rows) * height, 0, image.rows()));
        const int most = std::max(1, static_cast<int>(kStripBytes / 4 / static_cast<std::size_t>(count)));
        std::vector<std::uint8_t> strip(std::size_t{4} * static_cast<std::size_t>(count) *
                                        static_cast<std::size_t>(std::min(most, std::max(bottom - top, 1))));
        for (int r = top; r < bottom; r += most) {
            const int lines = std::min(most, bottom - r);
            image.read(inside, r, count, lines, strip.data());
            for (int line = 0; line < lines; ++line)
                for (int n = 0; n < count; ++n)
                    add(c + n, r + line,
                        &strip[std::size_t{4} *
                               (static_cast<std::size_t>(line) * static_cast<std::size_t>(count) + static_cast<std::size_t>(n))]);
        }
    }
    void add(std::int64_t c, std::int64_t r, const std::uint8_t* rgba) {
        std::array<float, 4>& sum = mean[static_cast<std::size_t>((r / height - row) * columns + floor_of(c, width) - column)];
        const float coverage = static_cast<float>(rgba[3]) / 255;
        for (std::size_t n = 0; n < 3; ++n) sum[n] += coverage * static_cast<float>(rgba[n]);
        sum[3] += static_cast<float>(rgba[3]);
    }
    static std::int64_t floor_of(std::int64_t n, std::int64_t divisor) {
        return n >= 0 ? n / divisor : -((-n + divisor - 1) / divisor);
    }
};

DrapeSampler::DrapeSampler(const BuildPlan& plan, const DrapeOptions& options) : plan_(plan), options_(options) {
    auto reader = std::make_unique<Reader>(options_);
    choose_level(*reader);
    readers_.give_back(std::move(reader));
}

DrapeSampler::~DrapeSampler() = default;

/// Rows of posts are equal steps of latitude, but for those beside a pole.
double DrapeSampler::latitude_deg(double row) const {
    const terrain::Lattice& lattice = plan_.lattice;
    const auto last = static_cast<double>(lattice.rows() - 1);
    if (row >= last)
        return std::max(-90.0,
                        base::degrees(lattice.latitude_rad(lattice.rows() - 1)) - plan_.header.step_lat_deg * (row - last));
    const auto above = static_cast<std::uint32_t>(row);
    const double share = row - above;
    return base::degrees(lattice.latitude_rad(above)) * (1 - share) + base::degrees(lattice.latitude_rad(above + 1)) * share;
}

/// Posts of the lattice, in fractions, where the image may meet it: spread over the terrain, and over the image.
std::vector<DrapeSampler::Post> DrapeSampler::probes(const Reader& reader) const {
    const terrain::FileHeader& h = plan_.header;
    const double last_column = h.columns - 1.0, last_row = h.rows - 1.0;
    std::vector<Post> posts;
    std::vector<double> x, y;
    for (int b = 0; b < kProbes; ++b)
        for (int a = 0; a < kProbes; ++a) {
            const double u = a / (kProbes - 1.0), v = b / (kProbes - 1.0);
            posts.push_back({last_column * u, last_row * v});
            x.push_back(reader.image.columns() * u);
            y.push_back(reader.image.rows() * v);
        }
    reader.to_degrees(x, y);
    const double middle_deg = h.west_deg + 0.5 * h.step_lon_deg * last_column;
    for (std::size_t n = 0; n < x.size(); ++n) {
        const double longitude_deg = x[n] + 360 * std::round((middle_deg - x[n]) / 360);
        const Post post{(longitude_deg - h.west_deg) / h.step_lon_deg,
                        (h.north_deg - y[n]) / h.step_lat_deg + (plan_.has_north_pole() ? 1 : 0)};
        if (post.column >= 0 && post.column <= last_column && post.row >= 0 && post.row <= last_row) posts.push_back(post);
    }
    return posts;
}

/// By the size of pixels where the image meets the terrain.
void DrapeSampler::choose_level(const Reader& reader) {
    const double columns = reader.image.columns(), rows = reader.image.rows();
    double pixels_x = 0, pixels_y = 0;  // a post, where they are smallest
    for (const Post& post : probes(reader)) {
        std::vector<double> x, y;
        for (const Post& moved : {post, Post{post.column + kMove, post.row}, Post{post.column, post.row + kMove}}) {
            x.push_back(plan_.header.west_deg + plan_.header.step_lon_deg * moved.column);
            y.push_back(latitude_deg(moved.row));
        }
        std::vector<Pixel> p;
        reader.to_pixels(x, y, p);
        // Comparisons that NaN refuses.
        if (!(p[0].x >= 0 && p[0].y >= 0 && p[0].x <= columns && p[0].y <= rows)) continue;
        const double per_post_x = std::max(std::abs(p[1].x - p[0].x), std::abs(p[2].x - p[0].x)) / kMove;
        const double per_post_y = std::max(std::abs(p[1].y - p[0].y), std::abs(p[2].y - p[0].y)) / kMove;
        if (per_post_x > 0) pixels_x = std::max(pixels_x, per_post_x);
        if (per_post_y > 0) pixels_y = std::max(pixels_y, per_post_y);
    }
    if (pixels_x == 0 || pixels_y == 0)
        throw UserError(reader.image.file() + ": the image shows nothing of " + plan_.source.source +
                        "; give one that does, or leave --drape out");
    const auto texel_posts = [](std::uint32_t level) { return std::ldexp(1 / kTexelsPerPost, static_cast<int>(level)); };
    const double pixel_posts = kNearlyAsFine / std::max(pixels_x, pixels_y);
    while (finest_level_ + 1 < plan_.levels() && texel_posts(finest_level_ + 1) <= pixel_posts) ++finest_level_;
    block_columns_ = std::max(1, static_cast<int>(texel_posts(finest_level_) * pixels_x * kNearlyAsFine));
    block_rows_ = std::max(1, static_cast<int>(texel_posts(finest_level_) * pixels_y * kNearlyAsFine));
}

/// Each knot is transformed, the texels between are interpolated; all are transformed where that is not accurate.
std::vector<DrapeSampler::Pixel> DrapeSampler::place_texels(const Reader& reader, std::uint32_t i, std::uint32_t j) const {
    const auto degrees_of = [&](std::uint32_t step, std::vector<double>& x, std::vector<double>& y) {
        const double texel = std::ldexp(1 / kTexelsPerPost, static_cast<int>(finest_level_));
        for (std::uint32_t b = 0; b < kDrapePosts; b += step)
            for (std::uint32_t a = 0; a < kDrapePosts; a += step) {
                x.push_back(plan_.header.west_deg + plan_.header.step_lon_deg * texel * (std::uint64_t{i} * kDrapeSteps + a));
                y.push_back(latitude_deg(texel * static_cast<double>(std::uint64_t{j} * kDrapeSteps + b)));
            }
    };
    std::vector<double> x, y;
    std::vector<Pixel> knots, places;
    degrees_of(kKnot / 2, x, y);
    reader.to_pixels(x, y, knots);
    if (interpolate(knots, places)) return places;
    x.clear();
    y.clear();
    degrees_of(1, x, y);
    reader.to_pixels(x, y, places);
    return places;
}

void DrapeSampler::sample(std::uint32_t i, std::uint32_t j, terrain::DrapePage& page) {
    std::unique_ptr<Reader> reader = readers_.take([this] { return std::make_unique<Reader>(options_); });
    const std::vector<Pixel> places = place_texels(*reader, i, j);
    Blocks blocks = Blocks::needed(places, *reader, block_columns_, block_rows_);
    blocks.read(*reader);
    for (std::size_t n = 0; n < places.size(); ++n) {
        const std::array<float, 4> color = blocks.at(places[n]);
        for (std::size_t c = 0; c < 4; ++c) page.rgba[n][c] = static_cast<std::uint8_t>(std::lround(color[c]));
    }
    readers_.give_back(std::move(reader));
}

}  // namespace tedavis::host_sim
