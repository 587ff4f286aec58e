#include "render_core/scene/glyph_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "render_core/base/check.hpp"

namespace tedavis::scene {
namespace {

constexpr int kAxisBits = 15;
constexpr std::uint32_t kLastCell = (1u << kAxisBits) - 1;
/// Of a full field, what a merge leaves at most: so that it is seldom full again.
constexpr std::uint32_t kKeptOf8 = 6;

/// With two empty bits between each two.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 16) & 0x0000FF0000FFull;
    bits = (bits | bits << 8) & 0x00F00F00F00Full;
    bits = (bits | bits << 4) & 0x0C30C30C30C3ull;
    return (bits | bits << 2) & 0x249249249249ull;
}

int highest_bit(std::uint64_t bits) {
    int highest = 0;
    for (int half = 32; half > 0; half /= 2)
        if (bits >> half != 0) {
            bits >>= half;
            highest += half;
        }
    return highest;
}

bool is_finite(const glm::dvec3& place) { return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z); }

GlyphSummary summary_of(const GlyphSite& site, const glm::vec3& place, GlyphValues values) {
    GlyphSummary summary;
    summary.place = place;
    summary.size_m = site.size_m > 0 && std::isfinite(site.size_m) ? site.size_m : 0;
    summary.over_ground_m = site.over_ground_m;
    summary.members = 1;
    const bool is_wind = values == GlyphValues::wind;
    if (site.state == ValueState::missing || !std::isfinite(site.value) || (is_wind && !std::isfinite(site.north_mps))) {
        summary.missing = 1;
        return summary;
    }
    summary.value = site.value;
    summary.state = site.state;
    summary.uncertainty = site.uncertainty;
    if (is_wind) {
        summary.north_mps = site.north_mps;
        summary.speed_mps = std::hypot(site.value, site.north_mps);
    }
    return summary;
}

}  // namespace

GlyphFrame level_frame(const earth::Geodetic& anchor, double reach_m) noexcept {
    const glm::dmat3 ned = earth::north_east_down(anchor.latitude_rad, anchor.longitude_rad);
    return {earth::to_ecef(anchor), {ned[1], ned[0], -ned[2]}, reach_m};
}

std::uint64_t GlyphField::bytes_needed(std::uint32_t sites) {
    constexpr std::uint64_t kASite = sizeof(GlyphSummary) + sizeof(GlyphGroup) + 2 * sizeof(std::uint64_t);
    return sites * kASite + 4 * alignof(std::max_align_t);
}

std::uint32_t GlyphField::sites_within(std::uint64_t bytes) {
    const std::uint64_t overhead = bytes_needed(0);
    if (bytes < overhead) return 0;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>((bytes - overhead) / (bytes_needed(1) - overhead), kMaxGlyphSites));
}

bool GlyphField::start(base::Arena& arena, std::uint32_t most_sites) {
    begin({}, GlyphValues::number);
    if (most_sites < kMinGlyphSites || most_sites > kMaxGlyphSites) return false;
    leaves_ = arena.allocate_array<GlyphSummary>(most_sites);
    groups_ = arena.allocate_array<GlyphGroup>(most_sites);
    keys_ = arena.allocate_array<std::uint64_t>(most_sites);
    other_keys_ = arena.allocate_array<std::uint64_t>(most_sites);
    return !leaves_.empty() && !groups_.empty() && !keys_.empty() && !other_keys_.empty();
}

void GlyphField::begin(const GlyphFrame& frame, GlyphValues values) {
    frame_ = frame;
    values_ = values;
    phase_ = Phase::collecting;
    root_ = {};
    shift_ = kIndexBits;
    cursor_ = count_ = given_ = misplaced_ = 0;
}

bool GlyphField::add(const GlyphSite& site) {
    TEDAVIS_CHECK(phase_ == Phase::collecting && !leaves_.empty());
    ++given_;
    const glm::vec3 place(glm::transpose(frame_.axes) * (site.place - frame_.anchor));
    if (!is_finite(place)) {
        ++misplaced_;
        return false;
    }
    if (count_ == leaves_.size()) merge();
    leaves_[count_++] = summary_of(site, place, values_);
    return true;
}

GlyphProgress GlyphField::step(std::uint32_t most_sites) {
    if (phase_ == Phase::collecting) {
        phase_ = Phase::coding;
        cursor_ = 0;
    }
    advance(Phase::linking, most_sites);
    return is_ready() ? GlyphProgress::done : GlyphProgress::more;
}

std::uint64_t GlyphField::code(const glm::vec3& place) const {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        // The anchor is a third of a cell away from the borders of all cells that hold it: what lies flat is not cut by rounding.
        const double share = (place[axis] + frame_.reach_m) / (3 * frame_.reach_m);
        const double cell = std::fmin(std::fmax(share * (kLastCell + 1.0), 0), kLastCell);
        code |= spread(static_cast<std::uint64_t>(cell)) << (2 - axis);
    }
    return code;
}

/// Up to the end of a phase, in which every leaf is visited once.
void GlyphField::advance(Phase last, std::uint32_t most_sites) {
    while (phase_ <= last) {
        const std::uint32_t now = std::min(most_sites, count_ - cursor_);
        for (std::uint32_t n = 0; n < now; ++n) visit(cursor_++);
        most_sites -= now;
        if (cursor_ < count_) return;
        end_phase();
    }
}

void GlyphField::visit(std::uint32_t n) {
    const int shift = kIndexBits + kDigitBits * pass_;
    const auto digit = [shift](std::uint64_t key) { return key >> shift & (kDigits - 1); };
    switch (phase_) {
        case Phase::coding: keys_[n] = code(leaves_[n].place) << kIndexBits | n; break;
        case Phase::counting: ++digits_[digit(from_keys()[n])]; break;
        case Phase::scattering: {
            const std::uint64_t key = from_keys()[n];
            to_keys()[digits_[digit(key)]++] = key;
            break;
        }
        // The groups are not there yet: their room holds the leaves in their new order.
        case Phase::gathering: groups_[n].summary = leaves_[other_keys_[n] & (kMaxGlyphSites - 1)]; break;
        case Phase::placing: leaves_[n] = groups_[n].summary; break;
        case Phase::linking: link(n); break;
        case Phase::collecting:
        case Phase::ready: break;
    }
}

void GlyphField::end_phase() {
    cursor_ = 0;
    switch (phase_) {
        case Phase::coding:
            pass_ = 0;
            std::fill(std::begin(digits_), std::end(digits_), 0u);
            phase_ = Phase::counting;
            return;
        case Phase::counting:
            sum_up_digits();
            phase_ = Phase::scattering;
            return;
        case Phase::scattering:
            ++pass_;
            std::fill(std::begin(digits_), std::end(digits_), 0u);
            phase_ = pass_ < kPasses ? Phase::counting : Phase::gathering;
            return;
        case Phase::gathering: phase_ = Phase::placing; return;
        case Phase::placing:
            if (shift_ > kIndexBits) unite_cells();
            waiting_count_ = 0;
            phase_ = Phase::linking;
            return;
        case Phase::linking: phase_ = Phase::ready; return;
        case Phase::collecting:
        case Phase::ready: return;
    }
}

/// From how often a digit comes to where its first key goes.
void GlyphField::sum_up_digits() {
    std::uint32_t before = 0;
    for (std::uint32_t& digit : digits_) {
        const std::uint32_t count = digit;
        digit = before;
        before += count;
    }
}

/// Makes room by larger cells.
void GlyphField::merge() {
    phase_ = Phase::coding;
    cursor_ = 0;
    advance(Phase::placing, kNoLimit);
    shift_ = merging_shift();
    unite_cells();
    phase_ = Phase::collecting;
}

/// Sorted leaves that share a cell become one.
void GlyphField::unite_cells() {
    std::uint32_t kept = 0;
    for (std::uint32_t begin = 0, end = 0; begin < count_; begin = end) {
        const std::uint64_t key = other_keys_[begin];
        GlyphSums sums(values_);
        for (; end < count_ && other_keys_[end] >> shift_ == key >> shift_; ++end) sums.add(leaves_[end]);
        keep_within_cell(sums, leaves_[begin].place);
        leaves_[kept] = sums.summary();
        other_keys_[kept++] = key;
    }
    count_ = kept;
}

/// The box of what was merged more than once grows by what its parts' boxes have beside their members; the cell bounds that.
void GlyphField::keep_within_cell(GlyphSums& sums, const glm::vec3& place) const {
    const int bits = kKeyBits + kIndexBits - shift_;
    const double side_m = 3 * frame_.reach_m;
    glm::dvec3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
        const double cells = std::ldexp(1.0, (bits + 2 - axis) / 3);
        const double cell = std::floor((place[axis] + frame_.reach_m) / side_m * cells);
        low[axis] = cell / cells * side_m - frame_.reach_m;
        high[axis] = (cell + 1) / cells * side_m - frame_.reach_m;
    }
    sums.keep_within(low, high);
}

/// The smallest cells that make room: keys are alike in all bits from there on.
int GlyphField::merging_shift() const {
    std::uint32_t differing[kKeyBits + kIndexBits] = {};
    for (std::uint32_t n = 0; n + 1 < count_; ++n) ++differing[highest_bit(other_keys_[n] ^ other_keys_[n + 1])];
    std::uint32_t cells = 1;
    int shift = kKeyBits + kIndexBits;
    const auto most = static_cast<std::uint32_t>(std::uint64_t{leaves_.size()} * kKeptOf8 / 8);
    while (shift > shift_ && cells + differing[shift - 1] <= most) cells += differing[--shift];
    return shift;
}

/// Of the leaf and the next one: groups whose second part ends here are whole.
void GlyphField::link(std::uint32_t n) {
    GlyphSums sums(values_);
    sums.add(leaves_[n]);
    GlyphRef ref = GlyphRef::leaf(n);
    const bool is_last = n + 1 == count_;
    const int bit = is_last ? kKeyBits + kIndexBits : highest_bit(other_keys_[n] ^ other_keys_[n + 1]);
    for (; waiting_count_ > 0 && waiting_[waiting_count_ - 1].bit < bit; --waiting_count_) {
        Waiting& whole = waiting_[waiting_count_ - 1];
        whole.sums.add(sums);
        groups_[whole.group] = {whole.sums.summary(), {whole.first, ref}};
        sums = whole.sums;
        ref = GlyphRef::group(whole.group);
    }
    if (is_last)
        root_ = ref;
    else
        waiting_[waiting_count_++] = {sums, ref, n, bit};
}

}  // namespace tedavis::scene
