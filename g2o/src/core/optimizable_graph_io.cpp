// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes .g2o files with the types of the Factory.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <istream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <system_error>
#include <typeinfo>
#include <utility>

#include "core/line_stream.h"
#include "core/shortest_numbers.h"
#include "core/unknown_tags.h"
#include "g2o/core/factory.h"
#include "g2o/core/optimizable_graph.h"
#include "g2o/stuff/logger.h"
#include "g2o/stuff/string_tools.h"
#include "io/characters.h"

namespace g2o {
namespace {

/// Reads one file into a graph, line by line. If a line refers to a vertex or a parameter that has not been
/// read yet, the line is read again at the end.
class Loader {
 public:
  Loader(OptimizableGraph& graph, const std::map<std::string, std::string>& renames)
      : graph_(graph), renames_(renames) {}

  bool load(std::istream& is) {
    constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";
    for (std::string line; std::getline(is, line);) {
      if (++number_ == 1 && line.rfind(kByteOrderMark, 0) == 0) line.erase(0, 3);
      read_line(line, true);
    }
    if (is.bad()) {
      ++number_;
      complain("this line cannot be read");
    }
    last_ = nullptr;
    for (auto& [number, line] : std::exchange(pending_, {})) {
      number_ = number;
      read_line(line, false);
    }
    unknown_.report();
    if (complaints_ > kShownComplaints)
      G2O_ERROR("{} more lines cannot be read", complaints_ - kShownComplaints);
    return complaints_ == 0;
  }

 private:
  template <class... Arguments>
  void complain(const char* format, const Arguments&... arguments) {
    if (++complaints_ > kShownComplaints) return;
    std::ostringstream text;
    logging::internal::append(text, format, arguments...);
    G2O_ERROR("line {}: {}", number_, text.str());
  }

  void read_line(const std::string& line, bool may_wait) {
    internal::LineStream fields(line);
    std::string tag;
    if (!(fields >> tag) || tag[0] == '#') return;
    if (tag == "FIX") return fix(fields, may_wait ? &line : nullptr);
    if (const auto renamed = renames_.find(tag); renamed != renames_.end()) tag = renamed->second;
    const bool known = Factory::instance()->knowsTag(tag);
    std::unique_ptr<HyperGraph::HyperGraphElement> element(known ? Factory::instance()->construct(tag)
                                                                 : nullptr);
    if (element == nullptr) {
      unknown_.add(tag, number_);
      return;
    }
    switch (element->elementType()) {
      case HyperGraph::HGET_PARAMETER:
        return read_parameter(std::move(element), tag, fields);
      case HyperGraph::HGET_VERTEX:
        return read_vertex(std::move(element), tag, fields);
      case HyperGraph::HGET_EDGE:
        return read_edge(std::move(element), tag, fields, may_wait ? &line : nullptr);
      case HyperGraph::HGET_DATA:
        return read_data(std::move(element), tag, fields);
      default:
        complain("expected the tag of a parameter, vertex, edge or data, got {}", tag);
    }
  }

  /// Whether the read() of an element accepts the fields. Some types end their read() with `return
  /// is.good()`, which is false if the last field is at the end of the line. So if read() returns false at
  /// the end of the line, this function calls it again with a blank after the fields.
  template <class Element>
  static bool accepts(Element& element, internal::LineStream& fields) {
    const std::istream::pos_type begin = fields.tellg();
    if (element.read(fields)) return !fields.fail();
    if (fields.fail() || !fields.eof() || !fields.problem.empty()) return false;
    fields.clear();
    fields.str(fields.str() + ' ');
    fields.seekg(begin);
    return element.read(fields) && !fields.fail();
  }

  /// Describes why the fields of a line could not be read.
  static std::string problem_of(internal::LineStream& fields) {
    if (!fields.problem.empty()) return fields.problem;
    if (!fields.fail()) return "the read() of this type does not accept the fields";
    fields.clear();
    std::string next;
    if (!(fields >> next)) return "expected more fields, got the end of the line";
    return "expected a number, got " + boxplus::in_quotes(next);
  }

  /// Whether the rest of the line is empty or a comment.
  bool at_end(const std::string& tag, internal::LineStream& fields) {
    std::string rest;
    if (!(fields >> rest) || rest[0] == '#') return true;
    complain("{}: expected the end of the line, got {}", tag, boxplus::in_quotes(rest));
    return false;
  }

  void fix(internal::LineStream& fields, const std::string* line_to_wait) {
    int id = 0;
    while (fields >> id) {
      if (OptimizableGraph::Vertex* v = graph_.vertex(id)) {
        v->setFixed(true);
      } else if (line_to_wait != nullptr) {
        pending_.emplace_back(number_, *line_to_wait);
        return;
      } else {
        complain("FIX: there is no vertex {}", id);
      }
    }
    fields.clear();
    at_end("FIX", fields);
  }

  void read_parameter(std::unique_ptr<HyperGraph::HyperGraphElement> element, const std::string& tag,
                      internal::LineStream& fields) {
    auto* p = static_cast<Parameter*>(element.get());
    int id = -1;
    if (!read_id(tag, "the id of a parameter", 0, fields, id)) return;
    p->setId(id);
    if (!accepts(*p, fields)) return complain("{} {}: {}", tag, id, problem_of(fields));
    if (!at_end(tag, fields)) return;
    if (!graph_.addParameter(p)) return complain("{} {}: the id is taken", tag, id);
    static_cast<void>(element.release());
  }

  void read_vertex(std::unique_ptr<HyperGraph::HyperGraphElement> element, const std::string& tag,
                   internal::LineStream& fields) {
    auto* v = static_cast<OptimizableGraph::Vertex*>(element.get());
    int id = -1;
    if (!read_id(tag, "the id of a vertex", 0, fields, id)) return;
    if (!accepts(*v, fields)) return complain("{} {}: {}", tag, id, problem_of(fields));
    if (!at_end(tag, fields)) return;
    v->setId(id);
    if (!graph_.addVertex(v)) return complain("{} {}: the id is taken", tag, id);
    static_cast<void>(element.release());
    last_ = v;
    last_data_ = nullptr;
  }

  bool read_id(const std::string& tag, const char* what, int lowest, std::istream& fields, int& id) {
    std::string text;
    fields >> text;
    return read_id(tag, what, lowest, text, id);
  }
  bool read_id(const std::string& tag, const char* what, int lowest, const std::string& text, int& id) {
    const char* const end = text.data() + text.size();
    const auto [read_to, error] = std::from_chars(text.data(), end, id);
    if (error == std::errc() && read_to == end && id >= lowest) return true;
    complain("{}: expected {}, got {}", tag, what, boxplus::in_quotes(text));
    return false;
  }

  /// Reads the ids of an edge's vertices: `count` ids or, if `count` is 0, all ids before "||". If an id is
  /// wrong or missing, reports that and returns false.
  bool read_ids(const std::string& tag, internal::LineStream& fields, size_t count, std::vector<int>& ids) {
    constexpr const char* kWhat = "the id of a vertex";
    ids.resize(count);
    for (int& id : ids) {
      if (!read_id(tag, kWhat, HyperGraph::UnassignedId, fields, id)) return false;
    }
    if (count > 0) return true;
    std::string field;
    while (fields >> field && field != "||") {
      if (!read_id(tag, kWhat, HyperGraph::UnassignedId, field, ids.emplace_back())) return false;
    }
    if (!fields.fail() && !ids.empty()) return true;
    complain("{}: expected the ids of vertices, then ||", tag);
    return false;
  }

  void read_edge(std::unique_ptr<HyperGraph::HyperGraphElement> element, const std::string& tag,
                 internal::LineStream& fields, const std::string* line_to_wait) {
    auto* e = static_cast<OptimizableGraph::Edge*>(element.get());
    std::vector<int> ids;
    const size_t arity = e->vertices().size();
    if (!read_ids(tag, fields, arity, ids)) return;
    if (arity == 0) e->resize(ids.size());
    for (size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] == HyperGraph::UnassignedId) continue;
      OptimizableGraph::Vertex* v = graph_.vertex(ids[i]);
      if (v == nullptr) {
        if (line_to_wait == nullptr) return complain("{}: there is no vertex {}", tag, ids[i]);
        pending_.emplace_back(number_, *line_to_wait);
        return;
      }
      e->setVertex(i, v);
    }
    if (!accepts(*e, fields)) return complain("{}: {}", tag, problem_of(fields));
    if (!at_end(tag, fields)) return;
    const auto is_missing = [this](int parameter) { return graph_.parameter(parameter) == nullptr; };
    const std::vector<int>& parameters = e->parameterIds();
    if (line_to_wait != nullptr && std::any_of(parameters.begin(), parameters.end(), is_missing)) {
      pending_.emplace_back(number_, *line_to_wait);
      return;
    }
    if (!graph_.addUnassignedEdge(e)) return complain("{}: the edge does not fit the graph", tag);
    static_cast<void>(element.release());
    last_ = e;
    last_data_ = nullptr;
  }

  void read_data(std::unique_ptr<HyperGraph::HyperGraphElement> element, const std::string& tag,
                 internal::LineStream& fields) {
    auto* d = static_cast<HyperGraph::Data*>(element.get());
    if (!d->read(fields)) return complain("{}: {}", tag, problem_of(fields));
    if (last_ == nullptr) return complain("{}: there is no vertex or edge before this line", tag);
    static_cast<void>(element.release());
    if (last_data_ == nullptr) {
      last_->addUserData(d);
    } else {
      d->setDataContainer(last_);
      last_data_->setNext(d);
    }
    last_data_ = d;
  }

  OptimizableGraph& graph_;
  const std::map<std::string, std::string>& renames_;
  std::vector<std::pair<int, std::string>> pending_;
  internal::UnknownTags unknown_;
  HyperGraph::DataContainer* last_ = nullptr;
  HyperGraph::Data* last_data_ = nullptr;
  int number_ = 0;
  static constexpr int kShownComplaints = 20;
  int complaints_ = 0;
};

/// Returns the tag of an element. If the type of the element is not registered, prints a message and returns
/// an empty string.
const std::string& tag_of(const HyperGraph::HyperGraphElement* element) {
  const std::string& tag = Factory::instance()->tag(element);
  if (tag.empty()) G2O_ERROR("save: no tag is registered for the type {}", typeid(*element).name());
  return tag;
}

/// Saves the elements until the stream fails. Returns false if an element was not written.
template <class Elements, class Save>
bool save_all(const std::ostream& os, const Elements& elements, Save save) {
  bool ok = true;
  for (auto* element : elements) {
    if (!os.good()) return false;
    ok = save(element) && ok;
  }
  return ok;
}

/// Returns `ok`, the result of an element's write(). If `ok` is false, prints a message.
bool written(bool ok, const std::string& tag) {
  if (!ok) G2O_ERROR("save: write() of {} returned false", tag);
  return ok;
}

}  // namespace

bool OptimizableGraph::load(std::istream& is) {
  return Loader(*this, _renamedTypesLookup).load(is);
}

bool OptimizableGraph::load(const char* filename) {
  if (filename == nullptr) {
    G2O_ERROR("load: expected the name of a file, got nullptr");
    return false;
  }
  std::error_code none;
  std::ifstream file(filename);
  if (!file || std::filesystem::is_directory(filename, none)) {  // some streams open folders
    G2O_ERROR("{} cannot be opened", filename);
    return false;
  }
  return load(file);
}

bool OptimizableGraph::save(const char* filename, int level) const {
  if (filename == nullptr) {
    G2O_ERROR("save: expected the name of a file, got nullptr");
    return false;
  }
  std::ofstream file(filename);
  if (!file) {
    G2O_ERROR("{} cannot be written", filename);
    return false;
  }
  const bool ok = save(file, level);
  if (file.flush()) return ok;
  G2O_ERROR("{} cannot be written", filename);
  return false;
}

bool OptimizableGraph::save(std::ostream& os, int level) const {
  std::vector<Edge*> edges;
  for (HyperGraph::Edge* u : _edges) {
    if (auto* e = static_cast<Edge*>(u); e->level() == level) edges.push_back(e);
  }
  std::sort(edges.begin(), edges.end(), EdgeIDCompare());
  std::set<Vertex*, VertexIDCompare> vertices;
  for (const auto& [id, v] : _vertices) {
    if (v->edges().empty()) vertices.insert(static_cast<Vertex*>(v));
  }
  for (const Edge* e : edges) {
    for (HyperGraph::Vertex* v : e->vertices())
      if (v != nullptr) vertices.insert(static_cast<Vertex*>(v));
  }
  bool ok = _parameters.write(os);
  ok = save_all(os, vertices, [&](Vertex* v) { return saveVertex(os, v); }) && ok;
  ok = save_all(os, edges, [&](Edge* e) { return saveEdge(os, e); }) && ok;
  return ok && os.good();
}

bool OptimizableGraph::saveSubset(std::ostream& os, HyperGraph::VertexSet& vset, int level) {
  bool ok = _parameters.write(os);
  std::vector<Edge*> edges;
  std::set<Vertex*, VertexIDCompare> vertices;
  for (HyperGraph::Vertex* v : vset) vertices.insert(static_cast<Vertex*>(v));
  for (HyperGraph::Edge* u : _edges) {
    auto* e = static_cast<Edge*>(u);
    const auto in_set = [&](HyperGraph::Vertex* v) { return vset.count(v) > 0; };
    if (e->level() == level && std::all_of(e->vertices().begin(), e->vertices().end(), in_set))
      edges.push_back(e);
  }
  std::sort(edges.begin(), edges.end(), EdgeIDCompare());
  ok = save_all(os, vertices, [&](Vertex* v) { return saveVertex(os, v); }) && ok;
  ok = save_all(os, edges, [&](Edge* e) { return saveEdge(os, e); }) && ok;
  return ok && os.good();
}

bool OptimizableGraph::saveSubset(std::ostream& os, HyperGraph::EdgeSet& eset) {
  bool ok = _parameters.write(os);
  std::vector<Edge*> edges;
  std::set<Vertex*, VertexIDCompare> vertices;
  for (HyperGraph::Edge* u : eset) {
    edges.push_back(static_cast<Edge*>(u));
    for (HyperGraph::Vertex* v : u->vertices())
      if (v != nullptr) vertices.insert(static_cast<Vertex*>(v));
  }
  std::sort(edges.begin(), edges.end(), EdgeIDCompare());
  ok = save_all(os, vertices, [&](Vertex* v) { return saveVertex(os, v); }) && ok;
  ok = save_all(os, edges, [&](Edge* e) { return saveEdge(os, e); }) && ok;
  return ok && os.good();
}

bool OptimizableGraph::saveVertex(std::ostream& os, Vertex* v) const {
  const std::string& tag = tag_of(v);
  if (tag.empty()) return false;
  ShortestNumbers out(os);
  out.stream() << tag << " " << v->id() << " ";
  const bool ok = written(v->write(out.stream()), tag);
  out.stream() << '\n';
  const bool data_ok = saveUserData(os, v->userData());
  if (v->fixed()) out.stream() << "FIX " << v->id() << '\n';
  return ok && data_ok && out.good();
}

bool OptimizableGraph::saveParameter(std::ostream& os, Parameter* p) const {
  const std::string& tag = tag_of(p);
  if (tag.empty()) return false;
  ShortestNumbers out(os);
  out.stream() << tag << " " << p->id() << " ";
  const bool ok = written(p->write(out.stream()), tag);
  out.stream() << '\n';
  return ok && out.good();
}

bool OptimizableGraph::saveEdge(std::ostream& os, Edge* e) const {
  const std::string& tag = tag_of(e);
  if (tag.empty()) return false;
  ShortestNumbers out(os);
  out.stream() << tag << " ";
  for (const HyperGraph::Vertex* v : e->vertices())
    out.stream() << (v == nullptr ? HyperGraph::UnassignedId : v->id()) << " ";
  const bool ok = written(e->write(out.stream()), tag);
  out.stream() << '\n';
  return saveUserData(os, e->userData()) && ok && out.good();
}

bool OptimizableGraph::saveUserData(std::ostream& os, HyperGraph::Data* d) const {
  ShortestNumbers out(os);
  bool ok = true;
  for (; d != nullptr; d = d->next()) {
    const std::string& tag = tag_of(d);
    ok = ok && !tag.empty();
    if (tag.empty()) continue;
    out.stream() << tag << " ";
    ok = written(d->write(out.stream()), tag) && ok;
    out.stream() << '\n';
  }
  return ok && out.good();
}

void OptimizableGraph::setRenamedTypesFromString(const std::string& types) {
  _renamedTypesLookup.clear();
  std::istringstream in(types);
  for (std::string pair; std::getline(in, pair, ',');) {
    const size_t sign = pair.find('=');
    if (sign == std::string::npos) {
      if (!trim(pair).empty()) G2O_ERROR("expected old=new, got {}", pair);
      continue;
    }
    const std::string from = trim(pair.substr(0, sign)), to = trim(pair.substr(sign + 1));
    if (!Factory::instance()->knowsTag(to)) {
      G2O_ERROR("expected a known tag after =, got {}", to);
      continue;
    }
    _renamedTypesLookup[from] = to;
  }
}

}  // namespace g2o
