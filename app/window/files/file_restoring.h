// Earlier states of a painting, out of its file and its backups.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

namespace suffuse {

class FileSaving;

/// Puts an earlier state in place of a window's painting, as a step that Undo takes back.
class FileRestoring : public QObject {
    Q_OBJECT

public:
    FileRestoring(const Workplace &place, FileSaving &saving, QObject *parent);

    /// The painting in a backup. Errors and damage are shown.
    void restoreFrom(const QString &backup);

private:
    void revert();
    void chooseBackup();
    void giveUpWhatIsInHand();

    Workplace m_place;
    FileSaving &m_saving;
};

} // namespace suffuse
