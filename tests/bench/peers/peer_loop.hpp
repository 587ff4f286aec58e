/// The conversation of a peer with tests/bench/peers/run: it says what it is, then answers each pose with its times.
///
///     PROGRAM FOLDER WIDTH HEIGHT [OPTION...]
///     out  ready {"version": "...", "build_ms": 12.5}
///     in   x y z heading pitch roll          out  done {"ms": [31.2], "bound_px": 1}
///
/// Before the answer the picture is drawn once without being timed, then once timed; its depths lie in FOLDER/NAME.depth.
#pragma once

#include <chrono>
#include <functional>
#include <iostream>

#include "tests/bench/peers/peer_frame.hpp"

namespace tedavis::peers {

template <class Work>
double spent_ms(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

struct PeerArguments {
    std::string folder;
    PictureSize size;
    std::string option;

    static PeerArguments of(int count, char** given) {
        if (count < 4) throw std::runtime_error("expects FOLDER WIDTH HEIGHT [OPTION]; tests/bench/peers/run starts it");
        return {given[1],
                {static_cast<std::uint32_t>(std::stoul(given[2])), static_cast<std::uint32_t>(std::stoul(given[3]))},
                count > 4 ? given[4] : ""};
    }
};

/// `answer` draws a pose and returns what stands between the braces of `done`.
inline void answer_poses(const std::string& ready, const std::function<std::string(const Pose&)>& answer) {
    std::cout << "ready {" << ready << "}" << std::endl;
    Pose pose;
    for (std::string line; std::getline(std::cin, line);) {
        if (!parse_pose(line, pose)) throw std::runtime_error("is no pose: " + line);
        const std::string text = answer(pose);
        std::cout << "done {" << text << "}" << std::endl;
    }
}

/// The body of a peer's main().
inline int run_peer(const char* name, const std::function<void()>& body) {
    try {
        body();
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << name << ": " << failure.what() << "\n";
        return 2;
    }
}

}  // namespace tedavis::peers
