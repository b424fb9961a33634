// What the edits of a document share.
#pragma once

#include "app/python/bindings.h"
#include "app/python/edited_painting.h"

#include <QStringList>

#include <array>
#include <optional>
#include <set>

namespace suffuse::python {

using DocumentClass = py::class_<EditedPainting>;

/// Does an edit without Python's lock. Returns whether it changed something.
inline bool push(EditedPainting &self, const char *name, const std::function<Edit(Document &)> &make)
{
    const py::gil_scoped_release released;
    return self.push(QString::fromUtf8(name), make);
}

/// Ids in whatever Python has them: a list, a set, an array.
inline std::set<std::uint64_t> idsOf(const py::iterable &ids)
{
    std::set<std::uint64_t> out;
    for (const py::handle id : ids)
        out.insert(py::int_(py::reinterpret_borrow<py::object>(id)).cast<std::uint64_t>());
    return out;
}

/// The place of a word among those that there are; raises DataError for others.
template <std::size_t N>
int choice(const char *name, const QString &word, const std::array<const char *, N> &words)
{
    QStringList known;
    for (std::size_t i = 0; i < N; ++i) {
        if (word == QLatin1String(words[i]))
            return int(i);
        known.append(QLatin1String(words[i]));
    }
    raise(Raised::Value,
          QStringLiteral("%1 %2: give one of %3").arg(QLatin1String(name), word, known.join(QStringLiteral(", "))));
}

/// Edits of whole strokes and of their colours.
void addStrokeEdits(DocumentClass &document);
/// Edits of curves, areas and fills.
void addShapeEdits(DocumentClass &document);
/// Edits of groups, and of when things are painted.
void addGroupEdits(DocumentClass &document);
void addTimeEdits(DocumentClass &document);

} // namespace suffuse::python
