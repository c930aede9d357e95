// A run's verdict as run.json holds it and info --json prints it (docs/format.md).
#pragma once

#include <nlohmann/json.hpp>

#include "core/run_verdict.hpp"

namespace packstone {

nlohmann::ordered_json to_json(const RunVerdict& verdict);

/// Throws nlohmann::json::exception where a part is missing or of another type, InputError for an unknown kind.
RunVerdict run_verdict_from(const nlohmann::ordered_json& json);

}  // namespace packstone
