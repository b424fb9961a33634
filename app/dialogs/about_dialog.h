#pragma once

#include <QDialog>

namespace suffuse {

/// Name, version, licence and what this build runs on.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget *parent = nullptr);
};

} // namespace suffuse
