/// A film of a run as an MP4 file (`replay --video`): one picture a step, at a constant rate.
///
/// H.264 where libav has x264, else MPEG-4 (ISO 14496-2); colors BT.709 with one sample of chroma for 2 x 2 pixels. Equal
/// pictures give equal bytes on the same libav: one thread, and nothing of the machine or the clock is written.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

struct VideoSettings {
    std::string path;  ///< ends in ".mp4"
    std::uint32_t width = 0, height = 0;
    double step_s = 1.0 / 30;  ///< above 0: of the flight, between two pictures
    std::string title;         ///< in the file
    base::Time begin;          ///< of the flight, at the first picture: the file's creation time and date
    /// Libav's names of encoders; the first one that is installed is used.
    std::vector<std::string> encoders = {"libx264", "mpeg4"};
};

/// Writes the film; without commit() no file appears.
class VideoFile {
public:
    /// Throws UserError where the file cannot be written, no encoder is installed, or none accepts pictures of this size and
    /// rate.
    explicit VideoFile(const VideoSettings& settings);
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    /// Adds a picture of the stated size. Throws UserError where the disk is full.
    void add(const RgbaView& picture);
    [[nodiscard]] std::uint64_t pictures() const;
    /// Ends the film and puts the file in its place; once, after at least one picture. Throws UserError as AtomicFile.
    void commit();

private:
    class Film;
    std::unique_ptr<Film> film_;
};

}  // namespace tedavis::host_sim
