// The menu of extensions, and what its entries do.
#pragma once

#include "app/window/workplace.h"

#include <QList>
#include <QObject>

class QAction;
class QMenu;

namespace suffuse {

class Extending : public QObject {
    Q_OBJECT

public:
    Extending(const Workplace &place, QObject *parent);
    ~Extending() override;

    /// Puts the extensions that are enabled into the menu, before the last entry. What is there changes with them.
    void fill(QMenu &menu);
    /// The entries of the menu that run an extension.
    const QList<QAction *> &actions() const { return m_actions; }

private:
    void addRows();
    void refill();
    /// The submenu in which an extension stands.
    QMenu &menuFor(const QStringList &titles);
    /// Asks what it needs to know, and runs it; `atOnce`: without asking.
    void run(const QString &id, bool atOnce);

    Workplace m_place;
    QMenu *m_menu = nullptr;
    QList<QAction *> m_actions;
    QList<QMenu *> m_submenus;
    QAction *m_line = nullptr;
};

} // namespace suffuse
