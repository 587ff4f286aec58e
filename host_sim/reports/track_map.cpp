#include "host_sim/reports/track_map.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/palette_picture.hpp"
#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/map_lines.hpp"
#include "host_sim/reports/phase_color.hpp"
#include "host_sim/reports/shaded_relief.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using Sample = RunStory::Sample;

constexpr double kWidth = 640, kFlattest = 0.4, kSteepest = 1.25;  // of the drawing, and its height as a share of it

/// A region and its drawing, in which longitude is shortened by the cosine of the middle latitude.
struct Map {
    GeoExtent extent;
    double height = 0;  // of the drawing

    [[nodiscard]] double x(double longitude_deg) const {
        return kWidth * (longitude_deg - extent.west_deg) / (extent.east_deg - extent.west_deg);
    }
    [[nodiscard]] double y(double latitude_deg) const {
        return height * (extent.north_deg - latitude_deg) / (extent.north_deg - extent.south_deg);
    }
};

double shortening(const GeoExtent& extent) {
    return std::max(std::cos(base::radians(0.5 * (extent.south_deg + extent.north_deg))), 0.05);
}

/// The tracks with a margin, no narrower and no flatter than a page can show.
Map map_of(const GeoExtent& extent) {
    constexpr double kMargin = 0.08, kMin_deg = 0.02;
    const double narrow = shortening(extent);
    const double tall_deg = std::max((extent.north_deg - extent.south_deg) * (1 + 2 * kMargin), kMin_deg);
    const double wide_deg = std::max((extent.east_deg - extent.west_deg) * narrow * (1 + 2 * kMargin), kMin_deg);
    const double width_deg = std::max(wide_deg, tall_deg / kSteepest), height_deg = std::max(tall_deg, wide_deg * kFlattest);
    const double middle_lat = 0.5 * (extent.south_deg + extent.north_deg), middle_lon = 0.5 * (extent.west_deg + extent.east_deg);
    return {{middle_lat - height_deg / 2, middle_lat + height_deg / 2, middle_lon - width_deg / narrow / 2,
             middle_lon + width_deg / narrow / 2},
            kWidth * height_deg / width_deg};
}

std::string relief(const Map& map, const terrain::TerrainDatabase& terrain) {
    constexpr std::size_t kColors = 64;
    const auto width = static_cast<std::uint32_t>(kWidth), height = static_cast<std::uint32_t>(std::lround(map.height));
    const RgbaPicture picture = shaded_relief(terrain, map.extent, width, std::max(height, 2u));
    return "<image width='" + decimal(kWidth, 0) + "' height='" + decimal(map.height, 1) +
           "' preserveAspectRatio='none' href='data:image/png;base64," +
           base64(encode_palette_png(with_palette(view_of(picture), kColors))) + "'/>";
}

template <class Place>
std::string point(const Map& map, const Place& place) {
    return decimal(map.x(place.longitude_deg), 1) + "," + decimal(map.y(place.latitude_deg), 1) + " ";
}

/// A light line below, so that the track is seen on any ground.
std::string line(const std::string& points, const std::string& color, double width = 2.5) {
    return "<polyline fill='none' stroke='#fff' stroke-width='" + decimal(width + 2, 1) + "' stroke-linejoin='round' points='" +
           points + "'/><polyline fill='none' stroke='" + color + "' stroke-width='" + decimal(width, 1) +
           "' stroke-linejoin='round' points='" + points + "'/>";
}

/// Places of a track that are farther apart in time have a gap between them.
template <class Place>
double longest_step_s(const std::vector<Place>& track) {
    constexpr double kUsualSteps = 4;
    std::vector<double> steps_s;
    for (std::size_t n = 1; n < track.size(); ++n) steps_s.push_back(track[n].time_s - track[n - 1].time_s);
    std::nth_element(steps_s.begin(), steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2), steps_s.end());
    return kUsualSteps * steps_s[steps_s.size() / 2];
}

/// A gap begins another line.
std::vector<MapLine> lines_of(const Map& map, const MapTrack& track) {
    const double gap_s = longest_step_s(track.places);
    std::vector<MapLine> lines(1);
    for (std::size_t n = 0; n < track.places.size(); ++n) {
        const MapTrack::Place& place = track.places[n];
        const bool is_late = !track.states_gaps && n > 0 && place.time_s - track.places[n - 1].time_s > gap_s;
        if (n > 0 && (is_late || !track.places[n - 1].joins_next)) lines.emplace_back();
        lines.back().push_back({map.x(place.longitude_deg), map.y(place.latitude_deg)});
    }
    return lines;
}

std::string one_track(const Map& map, const MapTrack& track) {
    std::string svg;
    for (const MapLine& part : lines_within(lines_of(map, track), kWidth, map.height)) {
        std::string points;
        for (const MapPoint& at : part) points += decimal(at.x, 1) + "," + decimal(at.y, 1) + " ";
        svg += line(points, track.color, track.width);
    }
    return svg;
}

const char* phase_at(const RunStory& story, double time_s) {
    for (const RunStory::PhaseSpan& span : story.phases())
        if (time_s >= span.begin_s && time_s <= span.end_s) return span.phase.c_str();
    return "unknown";
}

/// A gap in the track or another phase begins another line.
std::string track_lines(const Map& map, const RunStory& story, const std::vector<Sample>& track, double gap_s) {
    std::string lines, points;
    std::string color;
    for (std::size_t n = 0; n < track.size(); ++n) {
        const std::string now = phase_color(phase_at(story, track[n].time_s));
        const bool is_gap = n > 0 && track[n].time_s - track[n - 1].time_s > gap_s;
        if (!points.empty() && (is_gap || now != color)) {
            if (!is_gap) points += point(map, track[n]);
            lines += line(points, color);
            points.clear();
        }
        color = now;
        points += point(map, track[n]);
    }
    return lines + line(points, color);
}

std::string text_at(double x, double y, const std::string& text, const char* anchor = "start") {
    const std::string place = "x='" + decimal(x, 1) + "' y='" + decimal(y, 1) + "' text-anchor='" + anchor + "'";
    return "<text " + place + " class='map-halo'>" + escaped_html(text) + "</text><text " + place + " class='map-text'>" +
           escaped_html(text) + "</text>";
}

/// The texts of a map, none of them over another one or over the dot of an earlier one.
class MapTexts {
public:
    explicit MapTexts(double height) : height_(height) {}

    /// Where it must stand.
    std::string fixed(double x, double y, const std::string& text, const char* anchor = "start") {
        taken_.push_back(box_of(x, y, text, anchor));
        return text_at(x, y, text, anchor);
    }
    /// To the right of a dot, else at another side of it; empty where there is no room, and the dot has its title alone.
    std::string beside_dot(double x, double y, const std::string& text) {
        constexpr double kRadius = 5;
        taken_.push_back({x - kRadius, y - kRadius, x + kRadius, y + kRadius});
        struct Side {
            double x, y;
            const char* anchor;
        };
        static constexpr Side kSides[] = {{7, 4, "start"},  {-7, 4, "end"},   {0, -9, "middle"}, {0, 17, "middle"},
                                          {7, -7, "start"}, {7, 15, "start"}, {-7, -7, "end"},   {-7, 15, "end"}};
        for (const Side& side : kSides) {
            const Box box = box_of(x + side.x, y + side.y, text, side.anchor);
            if (!is_free(box)) continue;
            taken_.push_back(box);
            return text_at(x + side.x, y + side.y, text, side.anchor);
        }
        return {};
    }

private:
    struct Box {
        double left, top, right, bottom;
    };
    /// No font is known here: letters are as wide as they may be in the mean.
    static Box box_of(double x, double y, const std::string& text, const std::string& anchor) {
        constexpr double kLetter = 6.4, kAbove = 9, kBelow = 3;
        const double width = kLetter * static_cast<double>(text.size());
        const double left = anchor == "start" ? x : anchor == "end" ? x - width : x - width / 2;
        return {left, y - kAbove, left + width, y + kBelow};
    }
    [[nodiscard]] bool is_free(const Box& box) const {
        if (box.left < 0 || box.right > kWidth || box.top < 0 || box.bottom > height_) return false;
        return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) {
            return box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
        });
    }

    double height_;
    std::vector<Box> taken_;
};

/// A length of 1, 2 or 5 times a power of ten, between a tenth and a quarter of the map.
std::string scale_bar(const Map& map, MapTexts& texts) {
    const double width_m =
        base::radians(map.extent.east_deg - map.extent.west_deg) * shortening(map.extent) * earth::kMeanRadius_m;
    double length_m = std::pow(10, std::floor(std::log10(width_m / 4)));
    for (const double factor : {5.0, 2.0})
        if (length_m * factor <= width_m / 4) {
            length_m *= factor;
            break;
        }
    const double length = kWidth * length_m / width_m, y = map.height - 10;
    const std::string text = length_m >= 1000 ? decimal(length_m / 1000, 0) + " km" : decimal(length_m, 0) + " m";
    return "<path d='M10 " + decimal(y - 4, 1) + "v4h" + decimal(length, 1) +
           "v-4' fill='none' stroke='#111' stroke-width='1.5'/>" + texts.fixed(14 + length, y + 1, text);
}

std::string corners(const Map& map, MapTexts& texts) {
    const auto degrees = [](double value, const char* positive, const char* negative) {
        return decimal(std::abs(value), 3) + "\xC2\xB0 " + (value < 0 ? negative : positive);
    };
    return texts.fixed(
               6, 14,
               "north up, from " + degrees(map.extent.north_deg, "N", "S") + ", " + degrees(map.extent.west_deg, "E", "W")) +
           texts.fixed(kWidth - 6, map.height - 8,
                       "to " + degrees(map.extent.south_deg, "N", "S") + ", " + degrees(map.extent.east_deg, "E", "W"), "end");
}

std::string dot(const Map& map, MapTexts& texts, double latitude_deg, double longitude_deg, const std::string& fill,
                const std::string& label, const std::string& description) {
    const double x = map.x(longitude_deg), y = map.y(latitude_deg);
    return "<g><title>" + escaped_html(description) + "</title><circle cx='" + decimal(x, 1) + "' cy='" + decimal(y, 1) +
           "' r='4.5' fill='" + fill + "' stroke='#fff' stroke-width='1.5'/>" + texts.beside_dot(x, y, label) + "</g>";
}

std::string map_begin(const Map& map, const terrain::TerrainDatabase* terrain, const char* description) {
    const std::string svg = "<svg class='chart map' viewBox='0 0 " + decimal(kWidth, 0) + " " + decimal(map.height, 1) +
                            "' role='img' aria-label='" + description + "'><rect width='100%' height='100%' fill='#dcdcdc'/>";
    return terrain == nullptr ? svg : svg + relief(map, *terrain);
}

std::string map_end(const Map& map, MapTexts& texts, const std::vector<MapMark>& marks) {
    std::string svg;
    for (const MapMark& mark : marks)
        svg += dot(map, texts, mark.latitude_deg, mark.longitude_deg, mark.color, mark.label, mark.description);
    return svg + "</svg>\n";
}

/// Where several tracks begin or end at one place, it has the names of all of them; those beyond the map have no dot.
std::string track_ends(const Map& map, MapTexts& texts, const std::vector<const MapTrack*>& tracks, bool is_begin) {
    constexpr double kTogether = 14;
    std::string svg;
    std::vector<bool> is_named(tracks.size());
    const auto place_of = [&](std::size_t n) { return is_begin ? tracks[n]->places.front() : tracks[n]->places.back(); };
    for (std::size_t n = 0; n < tracks.size(); ++n) {
        const MapTrack::Place place = place_of(n);
        if (is_named[n] || !is_within({map.x(place.longitude_deg), map.y(place.latitude_deg)}, kWidth, map.height)) continue;
        std::string names = tracks[n]->name;
        for (std::size_t other = n + 1; other < tracks.size(); ++other) {
            const MapTrack::Place beside = place_of(other);
            if (std::hypot(map.x(beside.longitude_deg) - map.x(place.longitude_deg),
                           map.y(beside.latitude_deg) - map.y(place.latitude_deg)) > kTogether)
                continue;
            is_named[other] = true;
            names += ", " + tracks[other]->name;
        }
        const std::string label = names + (is_begin ? " begin" : " end") + (names.find(',') == std::string::npos ? "s" : "");
        svg += dot(map, texts, place.latitude_deg, place.longitude_deg, is_begin ? "#1a7f37" : "#111", label, label);
    }
    return svg;
}

/// Those of two places or more, which the extent then includes.
std::vector<const MapTrack*> drawable(const std::vector<MapTrack>& tracks, GeoExtent& extent) {
    std::vector<const MapTrack*> drawn;
    for (const MapTrack& track : tracks) {
        if (track.places.size() < 2) continue;
        drawn.push_back(&track);
        for (const MapTrack::Place& place : track.places) extent.include(place.latitude_deg, place.longitude_deg);
    }
    return drawn;
}

/// Samples with a valid position.
std::vector<Sample> placed_samples(const RunStory& story) {
    std::vector<Sample> track;
    for (const Sample& sample : story.samples())
        if (sample.position_valid) track.push_back(sample);
    return track;
}

/// Other flights may have gone anywhere: they are shown where they are near.
Map map_of_run(const std::vector<Sample>& track, const std::vector<MapTrack>& beside) {
    constexpr double kRoom = 0.25;
    GeoExtent run;
    for (const Sample& sample : track) run.include(sample.latitude_deg, sample.longitude_deg);
    const double tall_deg = kRoom * (run.north_deg - run.south_deg), wide_deg = kRoom * (run.east_deg - run.west_deg);
    const GeoExtent most{run.south_deg - tall_deg, run.north_deg + tall_deg, run.west_deg - wide_deg, run.east_deg + wide_deg};
    GeoExtent shown = run;
    for (const MapTrack& other : beside)
        for (const MapTrack::Place& place : other.places)
            if (other.places.size() > 1)
                shown.include(std::clamp(place.latitude_deg, most.south_deg, most.north_deg),
                              std::clamp(place.longitude_deg, most.west_deg, most.east_deg));
    return map_of(shown);
}

}  // namespace

MapTrackView view_of_track(const RunStory& story, const std::vector<MapTrack>& beside, std::size_t number) {
    const std::vector<Sample> track = placed_samples(story);
    const MapTrack& other = beside[number];
    if (track.size() < 2 || other.places.size() < 2) return {};
    const Map map = map_of_run(track, beside);
    const std::vector<MapLine> lines = lines_of(map, other);
    MapTrackView view;
    view.is_shown = !lines_within(lines, kWidth, map.height).empty();
    const auto is_on_map = [&](const MapPoint& at) { return is_within(at, kWidth, map.height); };
    for (std::size_t n = 1; n < lines.size(); ++n)
        view.has_gaps = view.has_gaps || is_on_map(lines[n - 1].back()) || is_on_map(lines[n].front());
    for (const MapLine& one : lines)
        for (const MapPoint& at : one) view.is_cut = view.is_cut || !is_within(at, kWidth, map.height);
    return view;
}

std::string track_map_svg(const RunStory& story, const terrain::TerrainDatabase* terrain, const std::vector<MapMark>& marks,
                          const std::vector<MapTrack>& beside) {
    const std::vector<Sample> track = placed_samples(story);
    if (track.size() < 2) return {};
    GeoExtent everywhere;
    const std::vector<const MapTrack*> others = drawable(beside, everywhere);
    const Map map = map_of_run(track, beside);
    std::string svg = map_begin(map, terrain, "The track on a map, north up");
    for (const MapTrack* const other : others) svg += one_track(map, *other);
    svg += track_lines(map, story, track, longest_step_s(track));
    MapTexts texts(map.height);
    svg += scale_bar(map, texts);
    svg += corners(map, texts);
    const auto end = [&](const Sample& sample, const char* fill, const char* label) {
        return dot(map, texts, sample.latitude_deg, sample.longitude_deg, fill, label,
                   std::string(label) + ", " + decimal(sample.time_s, 0) + " s");
    };
    svg += end(track.front(), "#1a7f37", "begin");
    svg += end(track.back(), "#111", "end");
    svg += track_ends(map, texts, others, true);
    svg += track_ends(map, texts, others, false);
    return svg + map_end(map, texts, marks);
}

std::string tracks_map_svg(const std::vector<MapTrack>& tracks, const terrain::TerrainDatabase* terrain,
                           const std::vector<MapMark>& marks) {
    GeoExtent extent;
    const std::vector<const MapTrack*> drawn = drawable(tracks, extent);
    if (drawn.empty()) return {};
    const Map map = map_of(extent);
    std::string svg = map_begin(map, terrain, "The tracks on a map, north up");
    for (const MapTrack* const track : drawn) svg += one_track(map, *track);
    MapTexts texts(map.height);
    svg += scale_bar(map, texts);
    svg += corners(map, texts);
    svg += track_ends(map, texts, drawn, true);
    svg += track_ends(map, texts, drawn, false);
    return svg + map_end(map, texts, marks);
}

}  // namespace tedavis::host_sim
