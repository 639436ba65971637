// Reports as JSON, the same words in every command.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "delone/check/delaunay.hpp"

namespace delone::cli {

using Json = nlohmann::ordered_json;

Json to_json(const CheckReport& report);

/// One object, one key a line; bytes that are not UTF-8 (in file names) become U+FFFD.
std::string to_text(const Json& json);

/// Seconds, to the microsecond.
double rounded(double seconds);

}  // namespace delone::cli
