#include "delone/build/method.hpp"

#include <algorithm>
#include <array>

#include "delone/base/errors.hpp"

namespace delone {
namespace {

constexpr int kAll = kMaxDimension;

constexpr std::array<MethodInfo, 12> kMethods{{
    {Method::automatic, "automatic", "what is fastest for the points", 1, kAll, true, true},
    {Method::cavity, "cavity", "one by one: remove the cells in conflict, fill the hole [For92] 4.3", 1, kAll, true,
     true},
    {Method::divide_conquer, "divide-conquer", "knit halves together [For92] 4.6", 2, 2, false, false},
    {Method::flip, "flip", "one by one: flip the facets of the link [ES96]", 1, kAll, true, true},
    {Method::flip_loop, "flip-loop", "the same, going round the point [GKS92] 3", 2, 2, false, true},
    {Method::flip_legalize, "flip-legalize", "the same, edge by edge [Slides]", 2, 2, false, true},
    {Method::history_simplices, "history-simplices", "cavities found through all hulls so far [For92] 4.4", 1, kAll,
     true, true},
    {Method::conflict_graph, "conflict-graph", "cavities known beforehand for every point [For92] 4.4", 1, kAll, true,
     true},
    {Method::lawson, "lawson", "triangulate from left to right, then flip [For92] 4.2", 2, 2, false, false},
    {Method::sweep, "sweep", "a line sweeps the plane [For92] 4.5", 2, 2, false, false},
    {Method::gift_wrap, "gift-wrap", "from facet to facet [For92] 4.6", 1, kAll, true, false},
    {Method::shelling, "shelling", "cell by cell along a line through the lifted hull [For92] 4.6", 1, kAll, true,
     false},
}};

bool serves(const MethodInfo& method, int dimension, bool weighted) {
  return dimension >= method.least_dimension && dimension <= method.most_dimension && (method.weights || !weighted);
}

std::string names(auto chosen) {
  std::string text;
  for (const MethodInfo& method : kMethods) {
    if (chosen(method)) text += (text.empty() ? "" : ", ") + std::string(method.name);
  }
  return text;
}

}  // namespace

std::span<const MethodInfo> methods() { return kMethods; }

const MethodInfo& info(Method method) { return *std::ranges::find(kMethods, method, &MethodInfo::method); }

Method method_named(const std::string& name) {
  const auto found = std::ranges::find_if(kMethods, [&](const MethodInfo& method) { return name == method.name; });
  if (found != kMethods.end()) return found->method;
  throw InputError("there is no method '" + name + "': there are " + names([](const MethodInfo&) { return true; }));
}

void require_served(Method method, int dimension, bool weighted) {
  const MethodInfo& asked = info(method);
  if (serves(asked, dimension, weighted)) return;
  throw InputError("the method " + std::string(asked.name) + " does not serve points of dimension " +
                   std::to_string(dimension) + (weighted ? " with weights" : "") +
                   "; these do: " + names([&](const MethodInfo& other) { return serves(other, dimension, weighted); }));
}

void require_ordered(Method method, Order order) {
  if (order == Order::automatic || info(method).ordered) return;
  if (method == Method::divide_conquer && (order == Order::hilbert || order == Order::lexicographic)) return;
  throw InputError("the method " + std::string(info(method).name) + " takes no order of insertion; these do: " +
                   names([](const MethodInfo& other) { return other.ordered; }));
}

}  // namespace delone
