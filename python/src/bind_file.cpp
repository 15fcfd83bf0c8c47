// SPDX-License-Identifier: BSD-3-Clause
// Files: load(), Graph.save().
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <string>

#include "bind.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/graph_file.h"
#include "convert.h"
#include "shown_progress.h"

namespace boxplus::python {
namespace {

ReadOptions::Indefinite read_policy(const std::string& name) {
  if (name == "refuse") return ReadOptions::Indefinite::kRefuse;
  if (name == "project") return ReadOptions::Indefinite::kProject;
  if (name == "as-given") return ReadOptions::Indefinite::kAsGiven;
  throw_value_error("information", "\"refuse\", \"project\" or \"as-given\"", py::str(name));
}

std::shared_ptr<GraphObject> load(const std::filesystem::path& path, bool lenient,
                                  const std::string& information, int threads) {
  const ReadOptions::Indefinite indefinite = read_policy(information);
  const ShownProgress progress("reading");
  const py::gil_scoped_release release;
  return std::make_shared<GraphObject>(
      read_graph(path.string(), {.lenient = lenient, .indefinite = indefinite, .threads = threads}));
}

}  // namespace

void bind_file(py::module_& module, GraphClass& graph) {
  using Note = GraphFile::Note;
  py::class_<Note>(module, "Note", "Something unusual in a file that is not an error.")
      .def_readonly("line", &Note::line, "0 if the note is about the whole file.")
      .def_readonly("column", &Note::column, "0 if the note is about the whole line.")
      .def_readonly("text", &Note::text)
      .def_readonly("skipped", &Note::skipped, "The line was skipped (lenient=True).")
      .def("__repr__",
           [](const Note& note) { return "line " + std::to_string(note.line) + ": " + note.text; });
  module.def(
      "load", &load, py::arg("path"), py::kw_only(), py::arg("lenient") = false,
      py::arg("information") = "refuse", py::arg("threads") = 0,
      "Reads a graph: .g2o, TORO, BAL or COLMAP. Raises FileError if the file cannot be opened, and "
      "InputError "
      "(file:line:column) for invalid input. With lenient=True, lines that cannot be read are skipped and "
      "noted in Graph.notes. `information` says what to do with an indefinite information matrix: \"refuse\" "
      "the "
      "file, \"project\" (the nearest positive semi-definite matrix replaces it), or \"as-given\". A note "
      "counts these edges.");
  graph
      .def_property_readonly(
          "notes", [](const GraphObject& self) { return self.file().notes; }, "The notes of load().")
      .def_property_readonly(
          "format", [](const GraphObject& self) { return self.file().format; },
          "The format that load() has read, or an empty text.")
      .def_property_readonly(
          "vertices_created", [](const GraphObject& self) { return self.file().vertices_created; },
          "True if the file lists only edges: optimize with start=\"chordal\".")
      .def(
          "save",
          [](const GraphObject& self, const std::filesystem::path& path, const std::string& format) {
            for (const std::string& loss : losses(path.string(), self.file(), {.format = format})) {
              const std::string text = path.string() + ": the format does not keep " + loss;
              if (PyErr_WarnEx(PyExc_RuntimeWarning, text.c_str(), 1) != 0) throw py::error_already_set();
            }
            const ShownProgress progress("writing");
            write_graph(path.string(), self.file(), {.format = format});
          },
          py::arg("path"), py::kw_only(), py::arg("format") = "",
          "Writes the graph, in the format of the extension unless `format` names one. Warns "
          "(RuntimeWarning) of what the format does not keep, such as bounds in .g2o.")
      .def(
          "losses",
          [](const GraphObject& self, const std::filesystem::path& path, const std::string& format) {
            return losses(path.string(), self.file(), {.format = format});
          },
          py::arg("path"), py::kw_only(), py::arg("format") = "",
          "What save() would warn of: a list of texts, which is empty if the format keeps everything.")
      .def(
          "to_text",
          [](const GraphObject& self, const std::string& format) {
            return format_graph(self.file(), {.format = format});
          },
          py::kw_only(), py::arg("format") = "", "The text that save() writes.");
}

}  // namespace boxplus::python
