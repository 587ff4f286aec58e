#include "render_core/perception/edge_detector.hpp"

#include <algorithm>
#include <cstring>

namespace tedavis::perception {
namespace {

std::size_t map_places(int width, int height) { return pixels_of(width + 2, height + 2); }
/// Rows that a blur adds up.
std::size_t rows_blurred(double sigma) { return 2 * static_cast<std::size_t>(gaussian_weights(sigma).radius) + 1; }
/// As many branches as an edge seldom has; where it has more, the map is read once more.
constexpr std::size_t kMaxWaiting = 256;

void write_edges(const std::uint8_t* __restrict map, std::uint8_t* __restrict edges, int width) {
    for (int x = 0; x < width; ++x) edges[x] = (map[x] & kStrongEdges) != 0 ? kEdge : 0;
}

std::int32_t squared_threshold(double length) { return static_cast<std::int32_t>(length * length); }

}  // namespace

std::size_t EdgeDetector::bytes(int most_width, int most_height, double most_sigma) {
    const std::size_t row = row_elements(most_width);
    const std::size_t rows = row * (4 + 2 * rows_blurred(most_sigma) + 2 * (3 + 3 + 2) + 4 * 4);
    constexpr std::size_t kAlignments = 8 * 16;
    return rows + map_places(most_width, most_height) + 4 * kMaxWaiting + kAlignments;
}

bool EdgeDetector::start(base::Arena& arena, int most_width, int most_height, double most_sigma) {
    if (most_width < 1 || most_height < 1 || most_width > kMaxPictureSide || most_height > kMaxPictureSide) return false;
    const std::size_t row = row_elements(most_width);
    source_ = arena.allocate_array<std::uint8_t>(row);
    levels_ = arena.allocate_array<std::uint8_t>(3 * row);
    sums_ = arena.allocate_array<std::uint16_t>(rows_blurred(most_sigma) * row);
    across_ = arena.allocate_array<std::int16_t>(3 * row);
    down_ = arena.allocate_array<std::int16_t>(3 * row);
    neighbors_ = arena.allocate_array<std::int16_t>(2 * row);
    squared_ = arena.allocate_array<std::int32_t>(4 * row);
    map_ = arena.allocate_array<std::uint8_t>(map_places(most_width, most_height));
    waiting_ = arena.allocate_array<std::uint32_t>(kMaxWaiting);
    if (waiting_.empty() || map_.empty() || squared_.empty() || neighbors_.empty() || down_.empty() || across_.empty() ||
        sums_.empty() || levels_.empty() || source_.empty())
        return false;
    most_width_ = most_width;
    most_height_ = most_height;
    sum_rows_ = static_cast<int>(rows_blurred(most_sigma));
    return true;
}

base::Span<const std::uint8_t> EdgeDetector::detect(const PictureView& picture, const CannySettings& settings) {
    if (!picture.is_valid() || !begin(picture.width, picture.height, settings) || !add_rows(picture)) return {};
    return finish();
}

bool EdgeDetector::begin(int width, int height, const CannySettings& settings) {
    if (!settings.is_valid() || width < 1 || height < 1 || width > most_width_ || height > most_height_) return false;
    const GaussianWeights weights = gaussian_weights(settings.sigma);
    if (2 * weights.radius + 1 > sum_rows_) return false;
    weights_ = weights;
    width_ = width;
    height_ = height;
    stride_ = row_elements(width);
    thresholds_ = {squared_threshold(settings.low), squared_threshold(settings.high)};
    blurred_across_ = next_row_ = 0;
    std::memset(map_.data(), 0, map_places(width, height));
    std::memset(squared_.data(), 0, 4 * stride_ * sizeof(std::int32_t));
    return true;
}

/// Rows follow each other from step to step, so that what a step reads is still near.
bool EdgeDetector::add_rows(const PictureView& rows) {
    if (!rows.is_valid() || rows.width != width_ || rows.height > height_ - blurred_across_) return false;
    for (int y = 0; y < rows.height; ++y) {
        blur_source(rows.row(y), rows.channels);
        for (; next_row_ < height_ + 2 && blurred_across_ > std::min(next_row_ + weights_.radius, height_ - 1); ++next_row_) {
            if (next_row_ < height_) blur_row(next_row_);
            find_crests_above(next_row_);
        }
    }
    return true;
}

/// A row of the map lies behind the same row of the result, which takes its place.
base::Span<const std::uint8_t> EdgeDetector::finish() {
    if (height_ < 1 || blurred_across_ < height_) return {};
    connect();
    for (int y = 0; y < height_; ++y)
        write_edges(map_.data() + pixels_of(width_ + 2, y + 1) + 1, map_.data() + pixels_of(width_, y), width_);
    const std::size_t pixels = pixels_of(width_, height_);
    width_ = height_ = 0;
    return {map_.data(), pixels};
}

GradientRow EdgeDetector::gradients(int y) {
    const std::size_t at = static_cast<std::size_t>(y % 3) * stride_ + kRowLead;
    return {across_.data() + at, down_.data() + at, squared_.data() + at};
}

std::uint16_t* EdgeDetector::sums(int y) { return sums_.data() + static_cast<std::size_t>(y % sum_rows_) * stride_ + kRowLead; }

void EdgeDetector::blur_source(const std::uint8_t* pixels, int channels) {
    std::uint8_t* row = source_.data() + kRowLead;
    copy_colors(packed_picture(pixels, width_, 1, channels), 0, row);
    repeat_ends(row, width_, weights_.radius);
    blur_across(row, sums(blurred_across_++), width_, weights_);
}

void EdgeDetector::blur_row(int y) {
    BlurRows rows{};
    for (int k = -weights_.radius; k <= weights_.radius; ++k) rows[k + weights_.radius] = sums(std::clamp(y + k, 0, height_ - 1));
    blur_down(rows, levels(y), width_, weights_);
    repeat_ends(levels(y), width_, 1);
}

/// A row of levels completes the gradient of the row above, and the crests of the row above that.
void EdgeDetector::find_crests_above(int y) {
    const std::int32_t* none = squared_.data() + 3 * stride_ + kRowLead;
    const int slope = y - 1, crest = y - 2;
    if (slope >= 0 && slope < height_)
        gradient({levels(std::max(slope - 1, 0)), levels(slope), levels(std::min(slope + 1, height_ - 1))}, neighbors_.data(),
                 width_, gradients(slope));
    if (crest < 0) return;
    const GradientRows rows{crest > 0 ? gradients(crest - 1).squared : none,
                            crest + 1 < height_ ? gradients(crest + 1).squared : none, gradients(crest)};
    thin(rows, thresholds_, width_, map_.data() + pixels_of(width_ + 2, crest + 1) + 1);
}

/// Makes strong what is connected with something strong. What finds no room to wait is found when the map is read again; each
/// reading makes at least one more pixel strong.
void EdgeDetector::connect() {
    const std::size_t first = static_cast<std::size_t>(width_) + 3, end = map_places(width_, height_) - first;
    do {
        some_were_refused_ = false;
        for (std::size_t place = first; place < end; ++place) {
            std::uint64_t eight = 0;
            if (place + 8 <= end) {
                std::memcpy(&eight, map_.data() + place, sizeof(eight));
                if ((eight & 0x7070707070707070u) == 0) {
                    place += 7;
                    continue;
                }
            }
            if ((map_.data()[place] & kStrongEdges) == 0) continue;
            spread_from(place);
            while (waiting_count_ > 0) spread_from(waiting_.data()[--waiting_count_]);
        }
    } while (some_were_refused_);
}

void EdgeDetector::spread_from(std::size_t place) {
    const std::size_t row = static_cast<std::size_t>(width_) + 2;
    const std::size_t around[8] = {place - row - 1, place - row,     place - row + 1, place - 1,
                                   place + 1,       place + row - 1, place + row,     place + row + 1};
    const std::uint8_t* map = map_.data();
    const auto strong = static_cast<std::uint8_t>((map[place] & kStrongEdges) >> 4);
    std::uint8_t any = 0;
    for (const std::size_t next : around) any |= map[next];
    if ((any & strong) == 0) return;
    for (const std::size_t next : around)
        if ((map[next] & strong) != 0) promote(next, strong);
}

void EdgeDetector::promote(std::size_t place, std::uint8_t strong) {
    std::uint8_t& pixel = map_.data()[place];
    const auto changed = static_cast<std::uint8_t>(pixel & strong);
    pixel = static_cast<std::uint8_t>((pixel & ~changed) | changed << 4);
    if (waiting_count_ < waiting_.size())
        waiting_.data()[waiting_count_++] = static_cast<std::uint32_t>(place);
    else
        some_were_refused_ = true;
}

}  // namespace tedavis::perception
