/// Options of a replay, in batch or in a window.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host_sim/options/accuracy_shown.hpp"
#include "host_sim/options/picture_options.hpp"

namespace tedavis::host_sim {

enum class FrameOutput : std::uint8_t { png, hash, none };

struct ReplayOptions {
    std::string log;
    std::string output;    ///< folder
    std::string switches;  ///< switch log; empty: none
    std::string switch_config = "one_hot";
    PictureOptions picture;
    AccuracyShown accuracy;              ///< in a window only at its start, and on the screen alone
    std::optional<double> from_s, to_s;  ///< seconds since the log's first frame
    std::optional<double> step_s;        ///< nothing: one frame of the device's rate; negative: backwards
    std::optional<FrameOutput> frames;   ///< nothing: pictures; in a window, hashes
    bool window = false;
    bool strict = false;      ///< findings give kCheckFailedExitCode
    bool layers = false;      ///< writes a layer mask beside every picture; not with window
    bool ledger = false;      ///< reports the cost of every effect that was replaced or left out; not with window
    std::string video;        ///< film of the pictures (.mp4); empty: none; not with window
    std::string tour;         ///< path file for the camera (host_sim/window/camera_tour.hpp); with window only
    std::string save_config;  ///< writes data, design and parameters to this file

    [[nodiscard]] FrameOutput frame_output() const { return frames.value_or(window ? FrameOutput::hash : FrameOutput::png); }
};

}  // namespace tedavis::host_sim
