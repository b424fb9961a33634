// A painting that is edited, with its undo steps.
#pragma once

#include "model/document/document.h"
#include "model/formats/files.h"

#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace suffuse::python {

/// Holds the painting and the steps that were done. Each step is a swap, so that undoing it leaves what redoes it
/// (model/document/edit.h). It is the program's undo stack without Qt's, which links Qt Gui. Several threads may use
/// it. A step that is open belongs to the thread that began it: whatever else changes something meanwhile throws
/// `std::runtime_error`, since it would become a part of that step, and go with it.
class EditedPainting {
public:
    /// `extras`: what lay beside the painting in its file.
    EditedPainting(PaintingPtr painting, std::shared_ptr<const DocumentExtras> extras);

    /// Does an edit, which becomes a step, or a part of the step that is open; what could be redone is forgotten.
    /// Returns false where the edit is empty or changes nothing.
    bool push(const QString &name, const std::function<Edit(Document &)> &make);
    bool undo();
    bool redo();

    /// All edits until `endStep` become one step. Steps within steps belong to the outermost.
    void beginStep(const QString &name);
    /// `keep`: whether the step stays; otherwise it is undone and forgotten.
    void endStep(bool keep);

    PaintingPtr painting() const;
    /// The painting with which it began, and what lay beside that.
    const PaintingPtr &begun() const { return m_begun; }
    const std::shared_ptr<const DocumentExtras> &extras() const { return m_extras; }
    Selection selection() const;
    void select(const Selection &selection);
    /// The names of the steps, the oldest first; the first `done` of them are done.
    struct Steps {
        std::vector<QString> names;
        std::size_t done = 0;
    };
    Steps steps() const;

private:
    struct Step {
        QString name;
        Edit back; ///< leads to the state before, or, where it was undone, to the one after
    };
    void exchange(Step &step);
    void checkThread() const;

    const PaintingPtr m_begun;
    const std::shared_ptr<const DocumentExtras> m_extras;
    mutable std::mutex m_mutex;
    Document m_document;
    std::vector<Step> m_steps;
    std::size_t m_done = 0;
    int m_open = 0;         ///< how many steps are open within each other
    bool m_isBegun = false; ///< whether the open step has an edit
    QString m_openName;
    std::thread::id m_owner; ///< of the step that is open
};

} // namespace suffuse::python
