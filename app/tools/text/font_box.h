#pragma once

#include <QComboBox>

namespace suffuse {

/// Chooses a family of fonts, by its list or by typing its name. The list is made when it is first asked for: to look
/// for all fonts of a machine takes long, and a program that starts needs none of them.
class FontBox : public QComboBox {
    Q_OBJECT

public:
    explicit FontBox(QWidget *parent = nullptr);

    /// Shows a family, also one that is not installed; emits nothing.
    void setFamily(const QString &family);
    void showPopup() override;

signals:
    void chosen(const QString &family); ///< it is installed

protected:
    void focusInEvent(QFocusEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void fill();
    void take();

    QString m_family;
};

} // namespace suffuse
