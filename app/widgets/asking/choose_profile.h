#pragma once

#include <QString>

class QWidget;

namespace suffuse {

/// Asks for the file of an ICC profile, beginning beside `before`, or else where the system keeps them. Empty if none
/// was chosen. Whether it is a profile is not looked at.
QString askForProfile(QWidget *parent, const QString &title, const QString &before = {});

} // namespace suffuse
