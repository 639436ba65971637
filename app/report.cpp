#include "report.hpp"

#include <cmath>

namespace delone::cli {

Json to_json(const CheckReport& report) {
  Json json;
  json["passed"] = report.passed();
  json["violations"] = report.violation_count;
  json["first_violations"] = report.violations;
  json["affine_dimension"] = report.affine_dimension;
  json["vertices"] = report.vertices;
  json["duplicates"] = report.duplicates;
  json["hidden"] = report.hidden;
  json["cells"] = report.cells;
  json["hull_facets"] = report.hull_facets;
  return json;
}

std::string to_text(const Json& json) {
  return json.dump(2, ' ', false, nlohmann::detail::error_handler_t::replace) + "\n";
}

double rounded(double seconds) { return std::round(seconds * 1e6) / 1e6; }

}  // namespace delone::cli
