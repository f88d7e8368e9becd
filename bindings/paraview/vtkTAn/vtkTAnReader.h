// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vtkTAnModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>
#include <string>

/// Meshes of known error out of models of TAn, as unstructured grids of tetrahedra: points in double precision, the
/// values under the name that the data have for them, the site of each point, and as field data the errors that the
/// mesh keeps. Another error of the same model reads no more than that mesh needs.
///
/// In parallel each process finds the mesh and keeps its piece of it, with as many layers of ghost cells as are asked
/// for. Used from one thread at a time, as all of VTK's algorithms.
class VTKTAN_EXPORT vtkTAnReader : public vtkUnstructuredGridAlgorithm {
public:
    static vtkTAnReader* New();
    vtkTypeMacro(vtkTAnReader, vtkUnstructuredGridAlgorithm);
    void PrintSelf(std::ostream& os, vtkIndent indent) override;

    /// The model: a path, or an address (http://, https://, tan+http:// for one that stays at its server).
    void SetFileName(const char* name);
    const char* GetFileName() const { return this->FileName.c_str(); }

    /// A file whose first line is the token that the server of an address requires; empty for none.
    void SetTokenFile(const char* name);
    const char* GetTokenFile() const { return this->TokenFile.c_str(); }

    ///@{
    /// The largest difference between a sample of the data and the mesh, in % of the range of values; where meshes are
    /// warped, the warping as well, in % of the diagonal. 1 at first.
    vtkSetClampMacro(Error, double, 0.0, 100.0);
    vtkGetMacro(Error, double);
    ///@}

    ///@{
    /// At most so many tetrahedra, for which the error becomes as large as it must; 0, as at first: any number.
    vtkSetClampMacro(Budget, vtkIdType, 0, VTK_ID_MAX);
    vtkGetMacro(Budget, vtkIdType);
    ///@}

    ///@{
    /// A ball in which the error is FocusError; it becomes Error over the distance FocusFalloff outside. Off at first.
    vtkSetMacro(Focus, bool);
    vtkGetMacro(Focus, bool);
    vtkBooleanMacro(Focus, bool);
    vtkSetVector3Macro(FocusCentre, double);
    vtkGetVector3Macro(FocusCentre, double);
    vtkSetClampMacro(FocusRadius, double, 0.0, VTK_DOUBLE_MAX);
    vtkGetMacro(FocusRadius, double);
    vtkSetClampMacro(FocusError, double, 0.0, 100.0);
    vtkGetMacro(FocusError, double);
    vtkSetClampMacro(FocusFalloff, double, 0.0, VTK_DOUBLE_MAX);
    vtkGetMacro(FocusFalloff, double);
    ///@}

    ///@{
    /// A box (least and largest x, y, z) outside of which nothing is read, off at first; and what becomes of
    /// tetrahedra at its border: 0 keeps those that touch it, 1 those within, 2 cuts them.
    vtkSetMacro(Region, bool);
    vtkGetMacro(Region, bool);
    vtkBooleanMacro(Region, bool);
    vtkSetVector6Macro(RegionBounds, double);
    vtkGetVector6Macro(RegionBounds, double);
    vtkSetClampMacro(RegionBorder, int, 0, 2);
    vtkGetMacro(RegionBorder, int);
    ///@}

    /// Whether this is the file of a model.
    static int CanReadFile(const char* name);

protected:
    vtkTAnReader();
    ~vtkTAnReader() override;

    int RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                           vtkInformationVector* outputs) override;
    int RequestData(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
    vtkTAnReader(const vtkTAnReader&) = delete;
    void operator=(const vtkTAnReader&) = delete;

    std::string FileName;
    std::string TokenFile;
    double Error = 1;
    vtkIdType Budget = 0;
    bool Focus = false;
    double FocusCentre[3] = {0, 0, 0};
    double FocusRadius = 1;
    double FocusError = 0.1;
    double FocusFalloff = 1;
    bool Region = false;
    double RegionBounds[6] = {0, 1, 0, 1, 0, 1}; ///< as VTK has bounds: least x, largest x, least y ...
    int RegionBorder = 0;

    struct Opened;
    std::unique_ptr<Opened> opened; ///< from the last update
};
