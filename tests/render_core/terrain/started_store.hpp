/// A TerrainStore over a written database, with memory of just the size it asks for.
#pragma once

#include <gtest/gtest.h>

#include "render_core/terrain/terrain_store.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::test_support {

struct StartedStore {
    StartedStore(const std::vector<std::uint8_t>& file, const terrain::StoreSettings& settings)
        : bytes(file),
          index(terrain::TerrainStore::index_bytes(settings)),
          records(terrain::TerrainStore::record_bytes(settings)),
          payloads(terrain::TerrainStore::payload_bytes(settings)),
          attributes(terrain::TerrainStore::attribute_bytes(settings)),
          drape(terrain::TerrainStore::drape_bytes(settings)) {
        base::Arena table_arena(table.data(), table.size());
        auto opened = terrain::TerrainDatabase::open(bytes, table_arena);
        EXPECT_TRUE(opened.ok());
        database = opened.value();
        base::Arena index_arena(index.data(), index.size()), record_arena(records.data(), records.size()),
            payload_arena(payloads.data(), payloads.size()), attribute_arena(attributes.data(), attributes.size()),
            drape_arena(drape.data(), drape.size());
        failure = store.start(database, bytes.reader, settings,
                              {index_arena, record_arena, payload_arena, attribute_arena, &drape_arena});
    }

    FlakyBytes bytes;
    std::vector<std::uint8_t> table = std::vector<std::uint8_t>(1 << 17);
    std::vector<std::uint8_t> index, records, payloads, attributes, drape;
    terrain::TerrainDatabase database;
    terrain::TerrainStore store;
    terrain::TdbFailure failure;
};

}  // namespace tedavis::test_support
