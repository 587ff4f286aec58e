/// Reads recorded gaze from CSV.
///
/// First line: names of columns, in any order. Required: `x`, `y`, from the picture's top left corner, in pixels, or, where no
/// value of the file is above 1, in shares of its width and height. Optional: `file` (the picture's name, with or without
/// folders), `time_s` (of the flight, as in its records). Lines that start with `#` are comments, other columns are ignored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tedavis::host_sim {

struct Fixation {
    double x = 0, y = 0;
    std::string file;  ///< empty where the file has no such column
    std::optional<double> time_s;
    std::size_t line = 0;  ///< from 1
};

struct FixationFile {
    std::string path;
    std::vector<Fixation> fixations;  ///< in the order of the file; not empty
    bool in_shares = false;
    bool has_files = false, has_times = false;
};

/// Throws UserError with file and line for what is no number, and for a file without any fixation.
[[nodiscard]] FixationFile read_fixations(const std::string& path);

/// The pixel of a picture that a fixation hits.
struct GazePixel {
    std::uint32_t x = 0, y = 0;
};
/// Returns the pixel of a fixation; nothing outside the picture.
[[nodiscard]] std::optional<GazePixel> gaze_pixel(const FixationFile& file, const Fixation& fixation, std::uint32_t width,
                                                  std::uint32_t height);
/// Returns the pixels of the fixations that hit the picture.
[[nodiscard]] std::vector<GazePixel> gaze_pixels(const FixationFile& file, const std::vector<const Fixation*>& fixations,
                                                 std::uint32_t width, std::uint32_t height);

/// Returns a sentence on how many fixations hit no picture; empty where all of them hit one.
[[nodiscard]] std::string words_about_missed(const FixationFile& file, std::size_t hits);

}  // namespace tedavis::host_sim
