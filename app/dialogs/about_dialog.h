#pragma once

#include <QDialog>

namespace suffuse {

/// Shows name, version, licence and the backends of this build.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget *parent = nullptr);
};

} // namespace suffuse
