// Selected strokes on their way to fewer ones.
#pragma once

#include "app/session/fitting/fit_job.h"
#include "render/refit/refit_target.h"

namespace suffuse {

class Editor;

/// The selected strokes of a painting, which others are to take the place of. It is a value that threads may share.
class RefitTask {
public:
    /// Those that are selected, in whole or in part, as the painting is now. The error says what to select instead.
    static Result<RefitTask> ofSelection(Editor &editor);

    std::size_t count() const { return m_scope->count(); }
    /// What a job is to read: pictures of what the strokes show, or of the picture of a file if that is not null.
    ReadTarget target(EncodedImage picture, const QString &place) const;
    /// Puts the strokes of a fit in place of the others, in one step, and selects them. Returns what is to be said:
    /// how many they are, and how far the picture is from what it was, or from the picture of that file.
    QString apply(Editor &editor, const FitResult &fit, EncodedImage picture, const QString &place) const;

private:
    std::shared_ptr<const refit::RefitScope> m_scope;
};

} // namespace suffuse
