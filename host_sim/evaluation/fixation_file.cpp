#include "host_sim/evaluation/fixation_file.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/csv_cells.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

class FixationReader {
public:
    explicit FixationReader(const std::string& path) { file_.path = path; }

    void read_line(std::string_view line) {
        ++line_number_;
        line = trimmed_cell(line);
        if (line.empty() || line.front() == '#') return;
        if (columns_ == 0)
            read_names(csv_cells(line));
        else
            read_row(csv_cells(line));
    }

    FixationFile finish() {
        if (columns_ == 0) throw UserError(file_.path + ": empty; its first line names the columns, such as x,y");
        if (file_.fixations.empty())
            throw UserError(file_.path + ": holds no fixation; add a line below the names of its columns");
        file_.in_shares = std::all_of(file_.fixations.begin(), file_.fixations.end(),
                                      [](const Fixation& fixation) { return fixation.x <= 1 && fixation.y <= 1; });
        return std::move(file_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw UserError(file_.path + ":" + std::to_string(line_number_) + ": " + what);
    }

    void read_names(const std::vector<std::string_view>& names) {
        columns_ = names.size();
        const auto find = [&](std::string_view name) {
            const auto found = std::find(names.begin(), names.end(), name);
            if (std::count(names.begin(), names.end(), name) > 1) refuse("two columns " + std::string(name) + "; leave one");
            return found == names.end() ? std::nullopt
                                        : std::optional<std::size_t>(static_cast<std::size_t>(found - names.begin()));
        };
        x_ = find("x"), y_ = find("y"), picture_ = find("file"), time_ = find("time_s");
        if (!x_ || !y_) refuse("no columns x and y; name the columns in the first line, such as x,y or file,x,y");
        file_.has_files = picture_.has_value();
        file_.has_times = time_.has_value();
    }

    [[nodiscard]] double number(std::string_view cell, const char* what) const {
        const std::optional<double> value = number_in(cell);
        if (!value) refuse("'" + std::string(cell) + "' is no number for " + what + "; correct it");
        return *value;
    }

    void read_row(const std::vector<std::string_view>& cells) {
        if (cells.size() != columns_)
            refuse(std::to_string(cells.size()) + " cells where the first line names " + std::to_string(columns_) +
                   " columns; correct it");
        Fixation fixation;
        fixation.line = line_number_;
        fixation.x = number(cells[*x_], "x");
        fixation.y = number(cells[*y_], "y");
        if (picture_) fixation.file = std::string(cells[*picture_]);
        if (time_) fixation.time_s = number(cells[*time_], "time_s");
        file_.fixations.push_back(std::move(fixation));
    }

    FixationFile file_;
    std::size_t line_number_ = 0, columns_ = 0;
    std::optional<std::size_t> x_, y_, picture_, time_;
};

/// Of a share, the far edge belongs to the last pixel; of pixels it lies outside.
std::optional<std::uint32_t> pixel_of(double place, bool is_share, std::uint32_t count) {
    if (!(place >= 0)) return std::nullopt;
    if (is_share) return std::min(static_cast<std::uint32_t>(place * count), count - 1);
    return place < count ? std::optional<std::uint32_t>(static_cast<std::uint32_t>(place)) : std::nullopt;
}

}  // namespace

FixationFile read_fixations(const std::string& path) {
    const std::string text = read_file(path);
    FixationReader reader(path);
    std::string_view rest = text;
    if (rest.substr(0, 3) == "\xef\xbb\xbf") rest.remove_prefix(3);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        reader.read_line(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return reader.finish();
}

std::optional<GazePixel> gaze_pixel(const FixationFile& file, const Fixation& fixation, std::uint32_t width,
                                    std::uint32_t height) {
    const std::optional<std::uint32_t> x = pixel_of(fixation.x, file.in_shares, width);
    const std::optional<std::uint32_t> y = pixel_of(fixation.y, file.in_shares, height);
    if (!x || !y) return std::nullopt;
    return GazePixel{*x, *y};
}

std::vector<GazePixel> gaze_pixels(const FixationFile& file, const std::vector<const Fixation*>& fixations, std::uint32_t width,
                                   std::uint32_t height) {
    std::vector<GazePixel> pixels;
    for (const Fixation* fixation : fixations)
        if (const auto pixel = gaze_pixel(file, *fixation, width, height)) pixels.push_back(*pixel);
    return pixels;
}

std::string words_about_missed(const FixationFile& file, std::size_t hits) {
    const std::size_t count = file.fixations.size();
    if (hits >= count) return {};
    return "note: " + file.path + ": " + std::to_string(count - hits) + " of " + std::to_string(count) +
           " fixations lie on none of the pictures and are left out";
}

}  // namespace tedavis::host_sim
