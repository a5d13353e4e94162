#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/file.h"
#include "io/input_object.h"
#include "io/input_stream.h"
#include "io/named_document.h"
#include "io/output_lines.h"
#include "io/retained_file.h"
#include "kernel/port.h"
#include "openevc/evc.h"
#include "python/bind.h"
#include "python/blank.h"
#include "python/values.h"
#include "run/sounds.h"
#include "sim/cycle_inputs.h"

// `openevc.OnBoard`: the kernel, one call a cycle, with the keys of `evc replay`.
namespace evc::python {
namespace {

/// What a cycle gave. It becomes text, and values of Python, when it is looked at.
class Outputs : public Blank {
 public:
  kernel::Outputs values;
  kernel::Planning planning;
  bool planned = false;
  std::unique_ptr<kernel::Display> display;  // where it is asked for
  std::vector<io::NamedSound> sounds;
  std::int64_t t_ms = 0;
  std::shared_ptr<const io::Configuration> configuration;

  /// The line of `evc replay`, without its end.
  std::string json() const {
    require(configuration != nullptr);
    std::string line;
    io::append_output(line, t_ms, values, planned ? &planning : nullptr, configuration->ntc_names, display.get(),
                      sounds);
    line.pop_back();
    return line;
  }
  const py::dict& dict() {
    if (!dict_) dict_ = object_of(json()).cast<py::dict>();
    return *dict_;
  }
  /// For another cycle.
  void forget() {
    dict_.reset();
    sounds.clear();
  }

 private:
  std::optional<py::dict> dict_;
};

/// What a unit remembers, and the signals that keep their value from cycle to cycle.
struct Snapshot : Blank {
  std::vector<std::byte> unit;
  sim::CycleInputs inputs;
  io::InputStream::Radio radio;
  std::optional<run::Sounds> sounds;  // of a unit whose outputs have the record of the display
  std::int64_t last_ms = 0;
  std::shared_ptr<const io::Configuration> configuration;
};

std::string type_of(const py::object& value) { return Py_TYPE(value.ptr())->tp_name; }

/// A flag of Python or of NumPy.
bool flag_of(const py::object& value, const char* name) {
  const py::object plain = py::hasattr(value, "tolist") ? py::object(value.attr("tolist")()) : value;
  if (!py::isinstance<py::bool_>(plain))
    throw io::ReadError{{"OnBoard", name, "a value of type " + type_of(value), "True or False"}};
  return plain.cast<bool>();
}

constexpr std::int64_t kNever = -1;
constexpr std::int64_t kLongestGap_ms = 24LL * 3600 * 1000;

class OnBoard : public Blank {
 public:
  OnBoard(const py::object& configuration, const py::object& persistent, const py::object& planning,
          const py::object& dmi)
      : configuration_(read(configuration)),
        unit_(std::make_unique<kernel::Unit>()),
        planning_(flag_of(planning, "planning")) {
    if (flag_of(dmi, "dmi")) sounds_.emplace();
    const kernel::Config config = configuration_->for_kernel();
    if (persistent.is_none())
      kernel::power_up(*unit_, config);
    else
      (void)kernel::power_up(*unit_, config,
                             value_of(io::read_retained(json_of(persistent, "persistent").dump(), "persistent")));
  }

  /// One cycle at `t_ms`, None: a cycle after the last one. With an error nothing has changed.
  std::shared_ptr<Outputs> step(const py::object& t_ms, const py::kwargs& inputs) {
    require(unit_ != nullptr);
    const std::int64_t now = time_of(t_ms);
    if (inputs.empty() && radio_.empty()) {
      cycle_.clear();
    } else {
      const std::int64_t before = last_ms_;
      auto [cycle, radio] = read(now, inputs);
      // Reading may run code of Python, and with it other threads.
      if (last_ms_ != before)
        throw io::ReadError{
            {"step", "t_ms " + std::to_string(now), "a step of another thread meanwhile", "one thread"}};
      cycle_ = std::move(cycle);
      radio_ = std::move(radio);
    }
    cycle_.t_ms = last_ms_ = now;
    std::shared_ptr<Outputs>& out = free_outputs();
    kernel::step(*unit_, cycle_.view(), out->values);
    out->t_ms = now;
    out->planned = planning_ && kernel::plan(*unit_, out->planning);
    if (sounds_) {
      if (out->display == nullptr) out->display = std::make_unique<kernel::Display>();
      kernel::show(*unit_, out->values, *out->display);
      sounds_->append(out->sounds, *out->display);
    }
    out->configuration = configuration_;
    return out;
  }

  Snapshot snapshot() const {
    require(unit_ != nullptr);
    Snapshot s;
    s.unit.resize(kernel::snapshot_size());
    s.inputs = cycle_;
    s.radio = radio_;
    s.sounds = sounds_;
    s.last_ms = last_ms_;
    s.configuration = configuration_;
    if (!kernel::snapshot(*unit_, s.unit)) throw std::bad_alloc();
    s.inputs.clear();
    return s;
  }

  void restore(const py::object& snapshot) {
    require(unit_ != nullptr);
    if (!py::isinstance<Snapshot>(snapshot))
      throw io::ReadError{{"restore", "snapshot", "a value of type " + type_of(snapshot), "what snapshot() gave"}};
    const Snapshot& s = snapshot.cast<const Snapshot&>();
    if (const auto fault = kernel::restore(*unit_, s.unit); fault != kernel::SnapshotFault::none)
      throw io::ReadError{{"snapshot", "", kernel::name(fault), "one of this program"}};
    cycle_ = s.inputs;
    radio_ = s.radio;
    // Of a unit without the record of the display: as that of a display that is switched on.
    if (sounds_) sounds_ = s.sounds ? *s.sounds : run::Sounds();
    last_ms_ = s.last_ms;
    configuration_ = s.configuration;
  }

  /// What is kept without power: `evc-persistent/1`.
  py::object retained() const {
    require(unit_ != nullptr);
    return object_of(io::retained_text(kernel::retained(*unit_)));
  }
  std::int64_t cycle_ms() const {
    require(unit_ != nullptr);
    return configuration_->cycle_ms;
  }
  std::optional<std::int64_t> t_ms() const { return last_ms_ == kNever ? std::nullopt : std::optional(last_ms_); }

 private:
  static std::shared_ptr<const io::Configuration> read(const py::object& given) {
    std::string file = "config";
    io::Json document = given.is_none() ? io::Json::object() : json_of(given, file);
    if (document.is_string()) {
      file = document.get<std::string>();
      document = value_of(io::guarded([&] { return io::parse_json(value_of(io::read_text(file)), file); }));
    }
    if (document.is_object()) {
      io::put_named(document, "train", "trains", {document, file});
      io::put_named(document, "national_values", "national_values", {document, file});
    }
    return std::make_shared<const io::Configuration>(value_of(io::read_configuration(document.dump(), file)));
  }

  std::int64_t time_of(const py::object& t_ms) const {
    if (t_ms.is_none()) return last_ms_ == kNever ? 0 : last_ms_ + configuration_->cycle_ms;
    if (PyLong_CheckExact(t_ms.ptr())) {
      int overflow = 0;
      const std::int64_t now = PyLong_AsLongLongAndOverflow(t_ms.ptr(), &overflow);
      if (overflow == 0 && now > last_ms_ && now - last_ms_ <= kLongestGap_ms) return now;
    }
    const io::Json document{{"t_ms", json_of(t_ms, "step", "t_ms")}};
    const io::JsonPlace place = io::JsonPlace(document, "step")["t_ms"];
    const std::int64_t now = place.integer(0, INT64_MAX / 4);
    if (now <= last_ms_) place.fail("a time after " + std::to_string(last_ms_));
    if (last_ms_ != kNever && now - last_ms_ > kLongestGap_ms)
      place.fail("a time within 24 h of " + std::to_string(last_ms_));
    return now;
  }

  /// The objects that a stream would have: the first one has the first input of each key, and so on.
  static std::vector<io::Json> objects_of(std::int64_t now, const py::kwargs& inputs) {
    std::vector<io::Json> objects;
    for (const auto& [key, value] : inputs) {
      const std::string name = key.cast<std::string>();
      // No input of `evc replay` is a list itself: a list has several of its kind.
      io::Json one = json_of(value, "step", name, "t_ms " + std::to_string(now));
      if (!one.is_array()) one = io::Json::array({std::move(one)});
      if (objects.size() < one.size()) objects.resize(one.size(), io::Json::object());
      for (std::size_t i = 0; i < one.size(); ++i) objects[i][name] = std::move(one[i]);
    }
    return objects;
  }

  std::pair<sim::CycleInputs, io::InputStream::Radio> read(std::int64_t now, const py::kwargs& inputs) const {
    std::pair<sim::CycleInputs, io::InputStream::Radio> next{cycle_, radio_};
    auto& [cycle, radio] = next;
    cycle.clear();
    std::optional<io::Train> entered;
    const std::vector<io::Json> objects = objects_of(now, inputs);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      std::string where = "t_ms " + std::to_string(now);
      if (objects.size() > 1) where += " [" + std::to_string(i) + "]";
      const io::JsonPlace place(objects[i], "step", where);
      for (const char* key : {"t_ms", "end"})
        if (const auto p = place.find(key)) p->fail("an input: a call is a cycle");
      io::read_inputs(place, now, *configuration_, radio, entered, cycle);
    }
    io::deliver_radio(cycle, radio);
    return next;
  }

  /// Memory for outputs that Python does not look at any more, or new one.
  std::shared_ptr<Outputs>& free_outputs() {
    for (std::shared_ptr<Outputs>& one : outputs_)
      if (one != nullptr && one.use_count() == 1) {
        one->forget();
        return one;
      }
    next_ = (next_ + 1) % outputs_.size();
    return outputs_[next_] = std::make_shared<Outputs>();
  }

  std::shared_ptr<const io::Configuration> configuration_;
  std::unique_ptr<kernel::Unit> unit_;
  sim::CycleInputs cycle_;
  io::InputStream::Radio radio_;  // not delivered yet
  std::int64_t last_ms_ = kNever;
  bool planning_;
  std::optional<run::Sounds> sounds_;  // where the record of the display is asked for
  std::array<std::shared_ptr<Outputs>, 2> outputs_;
  std::size_t next_ = 0;
};

std::string brief(const Outputs& out) {
  return "<openevc.Outputs t_ms=" + std::to_string(out.t_ms) + " mode=" + name(out.values.mode) +
         " level=" + name(out.values.level) + ">";
}

}  // namespace

void bind_on_board(py::module_& module) {
  // The lock of the interpreter is kept in every call: that only one thread uses a unit at a time is so certain.
  py::class_<Outputs, std::shared_ptr<Outputs>>(
      module, "Outputs",
      "What a cycle gave: a mapping with the fields of a line of `evc replay`, made when it is looked at.")
      .def("__getitem__", [](Outputs& o, const py::object& key) { return py::object(o.dict()[key]); })
      .def("__contains__", [](Outputs& o, const py::object& key) { return o.dict().contains(key); })
      .def("__len__", [](Outputs& o) { return o.dict().size(); })
      .def("__iter__", [](Outputs& o) { return py::iter(o.dict()); })
      .def("__repr__", brief)
      .def_property_readonly("json", &Outputs::json, "The line of `evc replay`, without its end.");
  const py::class_<Snapshot> snapshot(module, "Snapshot",
                                      "All that a unit remembers at a moment: of OnBoard.snapshot().");
  py::class_<OnBoard>(
      module, "OnBoard",
      "An on-board unit after power-up.\n\n"
      "config: the configuration of `evc replay`, a dictionary or a file; persistent: what a unit kept\n"
      "without power, `retained` of another one; planning: outputs have the advance display; dmi: they have\n"
      "the record of the display.")
      .def(py::init<const py::object&, const py::object&, const py::object&, const py::object&>(),
           py::arg("config") = py::none(), py::arg("persistent") = py::none(), py::arg("planning") = false,
           py::arg("dmi") = false)
      .def("step", &OnBoard::step, py::arg("t_ms") = py::none(),
           "One cycle at t_ms, milliseconds since power-up; None: cycle_ms after the last one.\n\n"
           "Keywords are the inputs of `evc replay`: odometer={...}, balise={...}, radio, driver, train, ...; a list "
           "has\n"
           "several of one kind. Signals keep their value. With an InputError nothing has changed.")
      .def("snapshot", &OnBoard::snapshot, "All that the unit remembers, with the signals that keep their value.")
      .def("restore", &OnBoard::restore, py::arg("snapshot"),
           "The unit goes on from the moment of a snapshot, of this or another unit.")
      .def_property_readonly("retained", &OnBoard::retained, "What is kept without power: `evc-persistent/1`.")
      .def_property_readonly("cycle_ms", &OnBoard::cycle_ms, "Length of a cycle.")
      .def_property_readonly("t_ms", &OnBoard::t_ms, "Time of the last step; None before the first one.");
}

}  // namespace evc::python
