// Where docks and tool bars stand, under names.
#pragma once

#include "app/window/workplace.h"

#include <QObject>
#include <QStringList>

#include <functional>

class QMenu;

namespace suffuse {

enum class DockSet;

/// The workspaces of all windows: Paint, Refine and Time, which come along, and those that people have saved. Choosing
/// one arranges the docks and tool bars of this window; what is arranged then is nobody's until it is saved.
class Workspaces : public QObject {
    Q_OBJECT

public:
    /// `arrange` puts docks and tool bars where they stand at the first start, and shows those of a set.
    Workspaces(const Workplace &place, std::function<void(DockSet)> arrange, QObject *parent);

    /// Of those that were saved, in the order of the alphabet.
    static QStringList names();
    /// Saves how this window is arranged, in place of what had the name.
    void save(const QString &name);
    /// Arranges the window. Returns false, and changes nothing, where there is none of the name, or its bytes are
    /// damaged.
    bool choose(const QString &name);
    static void remove(const QString &name);

    /// Fills the part of the menu that differs from time to time: those that were saved, and those to be deleted.
    void fillMenu(QMenu &menu);

private:
    void addRows();
    void askAndSave();

    Workplace m_place;
    std::function<void(DockSet)> m_arrange;
};

} // namespace suffuse
