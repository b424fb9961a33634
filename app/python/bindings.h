// What the parts of the Python module share.
#pragma once

#include "app/python/pybind.h"
#include "app/python/text_caster.h"
#include "model/formats/files.h"
#include "model/painting/painting.h"

#include <atomic>
#include <functional>
#include <memory>

namespace suffuse::python {

namespace py = pybind11;

/// A painting as Python holds it: an immutable value, and what lay beside it in its file.
struct PaintingValue {
    PaintingPtr painting;
    std::shared_ptr<const DocumentExtras> extras; ///< never null
    py::dict tables; ///< the arrays that were asked for; they cannot be written to, so everybody may have the same
};

/// A painting that was made of another one keeps what does not depend on the strokes: not the preview, nor the history.
PaintingValue derivedFrom(const PaintingValue &from, PaintingPtr painting);

/// A text of the program as Python says it: there are no options with dashes, and English has its plurals ("2
/// strokes"). Programs take these from a translation, which needs an application object; of these a process can have
/// one only, and it may be another library's.
QString inPython(QString message);

/// Python's classes of errors. All of them are `suffuse.Error`.
enum class Raised {
    Plain, ///< Error: the work failed
    Value, ///< DataError, a ValueError as well: what was given cannot be
    File   ///< FileError, an OSError as well: a file cannot be read or written
};
void addErrors(py::module_ &module);
/// Raises an error, with the text as `inPython` has it.
[[noreturn]] void raise(Raised kind, const QString &message);
/// The value of a result, or the error.
template <typename T>
T valueOf(Result<T> result, Raised kind)
{
    if (!result)
        raise(kind, result.error());
    return std::move(*result);
}
/// Warns as Python does, by `suffuse.LeftOutWarning`.
void warnLeftOut(const QString &message);

/// Does work that may take long, without Python's lock, so that other threads go on. Where the caller is Python's main
/// thread, Ctrl+C sets the flag that `work` gets, and raises KeyboardInterrupt when the work has ended.
/// `tell` is called meanwhile, with the lock and on the caller's thread, about twenty times a second, and when the work is
/// done; what it raises ends the work like Ctrl+C.
void withoutLock(const std::function<void(std::atomic<bool> &cancel)> &work, const std::function<void()> &tell = {});

/// How far work is that other threads do, told to a function of Python by `withoutLock`.
class WorkShare {
public:
    /// `progress`: a function, or None.
    explicit WorkShare(py::object progress) : m_progress(std::move(progress)) {}
    void set(double share) { m_share = share; } ///< [0, 1]; any thread
    /// What `withoutLock` calls; empty where nobody is to be told.
    std::function<void()> teller()
    {
        if (m_progress.is_none())
            return {};
        return [this] {
            if (const double share = m_share; share != m_told)
                m_progress(m_told = share);
        };
    }

private:
    py::object m_progress;
    std::atomic<double> m_share{0};
    double m_told = -1;
};

/// A path from str, bytes or os.PathLike.
QString pathOf(const py::object &path);

void addPaintings(py::module_ &module);
void addDocuments(py::module_ &module);
void addPictures(py::module_ &module);
void addProbes(py::module_ &module);
void addGradients(py::module_ &module);
void addFits(py::module_ &module);
void addRefits(py::module_ &module);
void addTiles(py::module_ &module);
void addFilms(py::module_ &module);

} // namespace suffuse::python
