/// BoardPort for a display that runs on the same machine as this program: by the display's record socket, an interface of the CAN
/// bus, and lines of gpio-sim for the panel's switches.
///
/// Thread  one. Failure  the constructor throws UserError, the other functions also BoardLost.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bus/socketcan/raw_can_socket.hpp"
#include "bus/socketcan/socketcan_source.hpp"
#include "bus/switches/switch_config.hpp"
#include "host_sim/flight_test/board_port.hpp"

namespace tedavis::host_sim {

struct LiveBoardOptions {
    std::string socket;       ///< path of the record socket
    std::string interface;    ///< "can0"
    std::string panel_lines;  ///< folder with sim_gpioN/pull of each line; empty: no panel
    bool can_fd = false;      ///< whether the display's bus takes CAN FD frames
};

class LiveBoard final : public BoardPort {
public:
    /// Connects to the socket and opens the bus and the lines. The n-th line of the panel, from 0, is line n of gpio-sim, or the
    /// one with the line's `offset`. `can` opens the bus, and must outlive this object.
    LiveBoard(const LiveBoardOptions& options, const bus::SwitchConfig& panel, bus::CanSocketPort& can);
    ~LiveBoard() override;
    LiveBoard(const LiveBoard&) = delete;
    LiveBoard& operator=(const LiveBoard&) = delete;

    [[nodiscard]] base::Time now() override;
    [[nodiscard]] std::optional<std::string> next_record(base::Time until) override;
    void send(const bus::CanFrame& frame) override;
    [[nodiscard]] std::vector<bus::CanFrame> take_received() override;
    [[nodiscard]] std::uint64_t dropped_frames() const override { return can_->statistics().dropped; }
    [[nodiscard]] bool has_panel() const override { return !pulls_.empty(); }
    void set_line(std::size_t line, bool level) override;

private:
    void connect_display();
    void open_bus();
    void find_lines(const bus::SwitchConfig& panel);
    void drain_bus();
    [[noreturn]] void refuse_bus(const std::string& otherwise);

    LiveBoardOptions options_;
    bus::CanSocketPort& can_port_;
    bus::SocketCanSettings can_settings_;
    std::unique_ptr<bus::SocketCanSource> can_;
    struct Pull {
        std::string path;
        bool active_low = false;
    };
    std::vector<Pull> pulls_;  ///< in the order of the panel's lines
    int display_ = -1;
    std::vector<char> packet_;
    bool keeps_received_ = false;  ///< set by the first call of take_received()
    std::vector<bus::CanFrame> received_;
};

}  // namespace tedavis::host_sim
