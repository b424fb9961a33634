// Edits of groups, and of when things are painted.
#include "undo/layers/group_edits.h"
#include "app/python/document_edits.h"
#include "undo/layers/merge_layers.h"
#include "undo/time_edits.h"

namespace suffuse::python {

namespace {

/// Microseconds of finite seconds.
Microseconds timeOf(const char *name, double seconds)
{
    if (!(std::abs(seconds) <= 1e9))
        raise(Raised::Value, QStringLiteral("%1 %2: give seconds, e.g. 1.5").arg(QLatin1String(name)).arg(seconds));
    return toMicroseconds(seconds);
}

} // namespace

void addGroupEdits(DocumentClass &document)
{
    using namespace py::literals;
    document
        .def(
            "group",
            [](EditedPainting &self, const QString &name) {
                return push(self, "Group", [&](Document &d) { return groupSelection(d, name); });
            },
            "name"_a = "")
        .def(
            "ungroup",
            [](EditedPainting &self) { return push(self, "Ungroup", [](Document &d) { return ungroupSelection(d); }); })
        .def(
            "set_group",
            [](EditedPainting &self, GroupId group, std::optional<QString> name, std::optional<bool> visible,
               std::optional<bool> locked) {
                self.beginStep(QStringLiteral("Change Group"));
                bool isDone = false;
                if (name)
                    isDone |= push(self, "", [&](Document &d) { return renameGroup(d, group, *name); });
                if (visible)
                    isDone |= push(self, "", [&](Document &d) { return setGroupVisible(d, group, *visible); });
                if (locked)
                    isDone |= push(self, "", [&](Document &d) { return setGroupLocked(d, group, *locked); });
                self.endStep(true);
                return isDone;
            },
            "group"_a, py::kw_only(), "name"_a = py::none(), "visible"_a = py::none(), "locked"_a = py::none())
        .def(
            "merge_down",
            [](EditedPainting &self, GroupId group) {
                return push(self, "Merge Down", [&](Document &d) { return mergeDown(d, group).edit; });
            },
            "group"_a)
        .def("show_all",
             [](EditedPainting &self) { return push(self, "Show All", [](Document &d) { return showAll(d); }); })
        .def("unlock_all",
             [](EditedPainting &self) { return push(self, "Unlock All", [](Document &d) { return unlockAll(d); }); });
}

void addTimeEdits(DocumentClass &document)
{
    using namespace py::literals;
    document
        .def(
            "retime",
            [](EditedPainting &self, double by) {
                const Microseconds time = timeOf("by", by);
                return push(self, "Retime", [=](Document &d) { return retime(*d.painting(), d.selection(), time); });
            },
            "by"_a)
        .def(
            "stretch",
            [](EditedPainting &self, double begin, double end) {
                const TimeSpan span{timeOf("begin", begin), timeOf("end", end)};
                if (span.end < span.begin)
                    raise(Raised::Value, QStringLiteral("end %1: is before the begin").arg(end));
                return push(self, "Stretch", [=](Document &d) { return stretch(*d.painting(), d.selection(), span); });
            },
            "begin"_a, "end"_a)
        .def(
            "set_pace",
            [](EditedPainting &self, const QString &pace) {
                const auto kind = Pace(choice("pace", pace, std::array{"even", "ease_in", "ease_out", "ease_in_out"}));
                return push(self, "Pace", [=](Document &d) { return setPace(d, kind); });
            },
            "pace"_a)
        .def(
            "freeze",
            [](EditedPainting &self, double time) {
                const Microseconds moment = timeOf("time", time);
                return push(self, "Freeze", [=](Document &d) { return freeze(d, moment); });
            },
            "time"_a)
        .def(
            "rewet",
            [](EditedPainting &self, double time, double extra) {
                const Microseconds moment = timeOf("time", time), longer = timeOf("extra", extra);
                return push(self, "Rewet", [=](Document &d) { return rewet(d, moment, longer); });
            },
            "time"_a, "extra"_a)
        .def("remove_rewetting", [](EditedPainting &self) {
            return push(self, "Remove Rewetting", [](Document &d) { return removeRewetting(d); });
        });
}

} // namespace suffuse::python
