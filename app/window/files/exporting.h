// Exporting a window's painting, by the dialogs and once more without them, and printing it.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

#include <memory>

namespace suffuse {

class ExportJob;
struct ExportSettings;

/// Remembers how the painting was exported last.
class Exporting : public QObject {
    Q_OBJECT

public:
    Exporting(const Workplace &place, QObject *parent);
    ~Exporting() override;

private:
    void addRows();
    void takeLast();
    void exportPicture();
    void exportAgain();
    void exportDrawing();
    void exportTimelapse();
    /// `inLarge`: to look at the page above all.
    void print(bool inLarge);
    void showOutcome(bool written, const QString &error);
    void sayWritten(const QString &path);

    Workplace m_place;
    ExportJob *m_job;
    std::unique_ptr<ExportSettings> m_last; ///< of this painting; null: none
};

} // namespace suffuse
