/// Random cases for the failure policy: signals in all states, conditions and designs. The same seed gives the same cases.
#pragma once

#include <cstdint>
#include <random>

#include "tests/support/flights/policy_states.hpp"

namespace tedavis::test_support {

struct PolicyCase {
    flight::AircraftState state = everything_valid();
    policy::DisplayConditions conditions = good_conditions();
    design::DesignSettings design = design::default_design_settings();

    [[nodiscard]] policy::DisplayDecisions decide() const {
        return policy::decide_display(state, kPolicyNow, conditions, design);
    }
};

class RandomPolicy {
public:
    explicit RandomPolicy(std::uint32_t seed) : random_(seed) {}

    [[nodiscard]] PolicyCase next() {
        PolicyCase made;
        put_signals(made.state);
        put_own_ship(made.state);
        put_conditions(made.conditions);
        put_view(made);
        return made;
    }

private:
    [[nodiscard]] bool one_in(std::uint32_t n) { return random_() % n == 0; }
    template <class T, std::size_t N>
    [[nodiscard]] T one_of(const T (&choices)[N]) {
        return choices[random_() % N];
    }

    void put_signals(flight::AircraftState& state) {
        using flight::Signal;
        const auto set = [&](Signal signal, double value) { state[signal] = {value, kPolicyNow}; };
        set(Signal::height_above_terrain, one_of({-50.0, -10.0, 200.0}));
        set(Signal::radio_height, one_of({2.0, 50.0, 90.0, 300.0}));
        set(Signal::decision_height, 60);
        set(Signal::baro_altitude, 590);
        set(Signal::minimum_altitude, one_of({490.0, 700.0}));
        if (one_in(20)) set(Signal::horizontal_accuracy, 5000);
        if (one_in(20)) set(Signal::vertical_accuracy, 5000);
        if (one_in(10)) set(Signal::pitch, one_of({-1.2, 1.2}));
        for (std::size_t n = 0; n < flight::kSignalCount; ++n)
            if (one_in(40)) put_signal(state, static_cast<Signal>(n), one_of(kBadStates));
        if (one_in(8))
            for (const Signal heading : {Signal::true_heading, Signal::magnetic_heading, Signal::true_track})
                put_signal(state, heading, one_of(kBadStates));
    }

    void put_own_ship(flight::AircraftState& state) {
        if (one_in(6)) state.own_ship.state = one_of(kBadStates);
        state.own_ship.height_is_geometric = !one_in(6);
        state.own_ship.height_is_on_qnh = !state.own_ship.height_is_geometric && one_in(2);
        state.own_ship.velocity_north_mps = one_of({3.0, 60.0});
        state.traffic.is_cut = one_in(4);
    }

    void put_conditions(policy::DisplayConditions& conditions) {
        using policy::TerrainSource;
        if (one_in(2))
            conditions.terrain = one_of({TerrainSource::none, TerrainSource::outside, TerrainSource::failed,
                                         TerrainSource::over_budget, TerrainSource::too_coarse, TerrainSource::above_own_ship});
        conditions.phase.phase = one_of({flight::kApproachFinal, flight::kTakeoffFirstClimb, flight::FlightPhase{}});
        conditions.phase.switch_fault = one_in(4);
        conditions.phase.disagreement = one_in(4);
        conditions.terrain_ahead =
            one_of({policy::TerrainAhead::none, policy::TerrainAhead::caution, policy::TerrainAhead::warning});
        conditions.obstacle_ahead =
            one_of({policy::TerrainAhead::none, policy::TerrainAhead::caution, policy::TerrainAhead::warning});
        conditions.databases = one_of({base::Currency::current, base::Currency::expired, base::Currency::not_yet_valid});
        for (bool* const condition : {&conditions.generated_flight, &conditions.terrain_is_coarse, &conditions.terrain_ends,
                                      &conditions.image_is_missing, &conditions.data_are_out_of_date, &conditions.data_are_stale,
                                      &conditions.is_reduced, &conditions.shows_measure, &conditions.is_map})
            *condition = one_in(3);
    }

    void put_view(PolicyCase& made) {
        if (made.conditions.is_map) made.design.view.mode = one_of({design::ViewMode::map, design::ViewMode::orthographic});
        made.design.view.map_orientation = one_of({design::MapOrientation::north_up, design::MapOrientation::track_up});
        if (made.conditions.is_map && one_in(3)) made.design.view.reference = design::Reference::flat;
    }

    std::mt19937 random_;
};

}  // namespace tedavis::test_support
