/// Times of frames over a flight as a picture (SVG): for each column the longest and the median frame of its moment, the designs
/// below.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace tedavis::bench {

struct TimedFrame {
    double at_s = 0;  ///< from the log's first frame
    double ms = 0, processor_ms = 0;
    std::string phase;                 ///< the design that the phase has
    std::string reason;                ///< why it may take longer than others; empty: none
    std::uint64_t compiled_bytes = 0;  ///< executable memory that the driver added
};

class FrameTimesPicture {
public:
    explicit FrameTimesPicture(const std::vector<TimedFrame>& frames) : frames_(frames) {
        for (const TimedFrame& frame : frames) highest_ms_ = std::max(highest_ms_, frame.ms);
        highest_ms_ = kStep_ms * (1 + static_cast<int>(highest_ms_ / kStep_ms));
    }

    [[nodiscard]] std::string text() const {
        std::string svg =
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1200\" height=\"330\" "
            "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"1200\" height=\"330\" fill=\"#fff\"/>\n";
        for (int ms = 0; ms <= highest_ms_; ms += kStep_ms)
            svg += line(kLeft, y_of(ms), kLeft + kColumns, y_of(ms), "#ddd") + words(4, y_of(ms) + 4, std::to_string(ms) + " ms");
        return svg + columns() + phases() + "</svg>\n";
    }

private:
    static constexpr int kLeft = 60, kColumns = 1120, kTop = 16, kHeight = 250, kStep_ms = 50;

    static std::string line(double x0, double y0, double x1, double y1, const char* color) {
        char text[160];
        std::snprintf(text, sizeof text, "<path d=\"M%g %.1fL%g %.1f\" stroke=\"%s\"/>\n", x0, y0, x1, y1, color);
        return text;
    }
    static std::string upright(double x, double from, double to) {
        char text[64];
        std::snprintf(text, sizeof text, "M%g %.1fV%.1f", x, from, to);
        return text;
    }
    static std::string stroke(const std::string& path, const char* color) {
        return "<path d=\"" + path + "\" stroke=\"" + color + "\"/>\n";
    }
    static std::string words(double x, double y, const std::string& text) {
        char place[64];
        std::snprintf(place, sizeof place, "<text x=\"%g\" y=\"%.1f\">", x, y);
        return place + text + "</text>\n";
    }
    [[nodiscard]] double y_of(double ms) const { return kTop + kHeight * (1 - ms / highest_ms_); }
    [[nodiscard]] std::size_t first_of(int column) const {
        return frames_.size() * static_cast<std::size_t>(column) / static_cast<std::size_t>(kColumns);
    }

    /// From the median to the longest frame; red where the longest has no reason.
    [[nodiscard]] std::string columns() const {
        std::string medians, explained, unexplained;
        for (int column = 0; column < kColumns; ++column) {
            const std::size_t begin = first_of(column), end = std::max(first_of(column + 1), begin + 1);
            if (begin >= frames_.size()) break;
            std::vector<double> ms;
            const TimedFrame* longest = &frames_[begin];
            for (std::size_t n = begin; n < std::min(end, frames_.size()); ++n) {
                ms.push_back(frames_[n].ms);
                if (frames_[n].ms > longest->ms) longest = &frames_[n];
            }
            std::nth_element(ms.begin(), ms.begin() + static_cast<std::ptrdiff_t>(ms.size() / 2), ms.end());
            const double median = ms[ms.size() / 2], x = kLeft + column + 0.5;
            medians += upright(x, y_of(0), y_of(median));
            (longest->reason.empty() ? unexplained : explained) += upright(x, y_of(median), y_of(longest->ms));
        }
        return stroke(medians, "#8fb4d8") + stroke(explained, "#e0a94a") + stroke(unexplained, "#c0504d");
    }

    [[nodiscard]] std::string phases() const {
        std::string svg;
        std::size_t begin = 0;
        for (std::size_t n = 1; n <= frames_.size(); ++n) {
            if (n < frames_.size() && frames_[n].phase == frames_[begin].phase) continue;
            const double scale = static_cast<double>(kColumns) / static_cast<double>(frames_.size());
            const double x = kLeft + static_cast<double>(begin) * scale, end = kLeft + static_cast<double>(n) * scale;
            svg += line(x, kTop + kHeight, x, kTop + kHeight + 24, "#444");
            if (end - x > 8.0 * static_cast<double>(frames_[begin].phase.size()))
                svg += words(x + 4, kTop + kHeight + 18, frames_[begin].phase);
            begin = n;
        }
        char range[96];
        std::snprintf(range, sizeof range, "%.0f s to %.0f s: %zu frames; blue: median of a column, ", frames_.front().at_s,
                      frames_.back().at_s, frames_.size());
        return svg +
               words(kLeft, kTop + kHeight + 44,
                     range + std::string("above it its longest frame: yellow where the record has a reason for it, else red"));
    }

    const std::vector<TimedFrame>& frames_;
    double highest_ms_ = 0;
};

inline bool write_frame_times(const std::vector<TimedFrame>& frames, const std::string& path) {
    std::ofstream file(path);
    file << FrameTimesPicture(frames).text();
    return static_cast<bool>(file.flush());
}

}  // namespace tedavis::bench
