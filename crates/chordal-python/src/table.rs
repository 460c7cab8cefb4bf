//! Columns that Python libraries read where they lie.

use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::ffi::FFI_ArrowSchema;
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::{Float64Type, UInt32Type};
use arrow_array::{Array, ArrayRef, Float64Array, RecordBatch, RecordBatchIterator};
use arrow_buffer::{Buffer, ScalarBuffer};
use arrow_schema::{ArrowError, DataType};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict};

use crate::error;

/// Rows and columns. It never changes.
#[pyclass(frozen, module = "chordal._chordal")]
pub struct Table {
    batch: RecordBatch,
}

impl Table {
    /// Moves the numbers into one piece of memory, column after column, so that columns which
    /// lie evenly apart are an array of two dimensions as they are.
    ///
    /// # Errors
    /// None that the rows themselves could cause.
    pub fn new(batch: RecordBatch) -> Result<Table, ArrowError> {
        let (schema, columns, rows) = batch.into_parts();
        let is_number = |column: &ArrayRef| column.data_type() == &DataType::Float64;
        let count = columns.iter().filter(|column| is_number(column)).count();
        let mut values: Vec<f64> = Vec::with_capacity(count * rows);
        let mut kept: Vec<Result<ArrayRef, Option<arrow_buffer::NullBuffer>>> = Vec::new();
        // Each column is let go when it has been copied.
        for column in columns {
            if is_number(&column) {
                values.extend_from_slice(column.as_primitive::<Float64Type>().values());
                kept.push(Err(column.nulls().cloned()));
            } else {
                kept.push(Ok(column));
            }
        }
        let block = Buffer::from(values);
        let mut from = 0;
        let columns = kept.into_iter().map(|column| {
            column.unwrap_or_else(|nulls| {
                let values = ScalarBuffer::new(block.clone(), from, rows);
                from += rows;
                Arc::new(Float64Array::new(values, nulls))
            })
        });
        let columns = columns.collect();
        Ok(Table { batch: RecordBatch::try_new(schema, columns)? })
    }

    fn numbers(&self, name: &str) -> PyResult<&ArrayRef> {
        let known = || PyKeyError::new_err(format!("there is no column `{name}`"));
        self.batch.column_by_name(name).ok_or_else(known)
    }
}

#[pymethods]
impl Table {
    fn __len__(&self) -> usize {
        self.batch.num_rows()
    }

    /// The names of the columns, in order.
    #[getter]
    fn column_names(&self) -> Vec<String> {
        self.batch.schema_ref().fields().iter().map(|field| field.name().clone()).collect()
    }

    /// The type of each column as Arrow calls it, and its unit.
    #[getter]
    fn fields(&self) -> Vec<(String, String, Option<String>)> {
        let fields = self.batch.schema_ref().fields().iter();
        fields
            .map(|field| {
                let unit = field.metadata().get("unit").cloned();
                (field.name().clone(), field.data_type().to_string(), unit)
            })
            .collect()
    }

    /// What the table says about itself.
    #[getter]
    fn metadata(&self) -> std::collections::BTreeMap<String, String> {
        let metadata = self.batch.schema_ref().metadata();
        metadata.iter().map(|(key, value)| (key.clone(), value.clone())).collect()
    }

    /// Bytes that the columns take.
    #[getter]
    fn nbytes(&self) -> usize {
        // Numbers share one piece of memory, which counts once.
        let columns = self.batch.columns().iter();
        columns.map(|column| column.to_data().get_slice_memory_size().unwrap_or(0)).sum()
    }

    /// Columns of numbers as one array (rows, columns), where they lie evenly apart.
    fn block(&self, names: Vec<String>) -> PyResult<Option<NumberBuffer>> {
        let arrays = names.iter().map(|name| self.numbers(name)).collect::<PyResult<Vec<_>>>()?;
        if arrays.iter().any(|array| array.data_type() != &DataType::Float64) {
            return Ok(None);
        }
        let at = |array: &ArrayRef| array.as_primitive::<Float64Type>().values().as_ptr() as usize;
        let places: Vec<usize> = arrays.iter().map(|array| at(array)).collect();
        let Some(&first) = places.first() else { return Ok(None) };
        let separate = places.get(1).map_or(0, |second| second.wrapping_sub(first));
        let even = places.windows(2).all(|pair| pair[1].wrapping_sub(pair[0]) == separate);
        // All numbers of a table lie in one piece of memory, so what is between them is ours.
        let ahead = places.windows(2).all(|pair| pair[1] > pair[0]) || self.batch.num_rows() == 0;
        if !(even && ahead) {
            return Ok(None);
        }
        Ok(Some(NumberBuffer {
            address: first,
            shape: vec![self.batch.num_rows(), names.len()],
            strides: vec![8, separate],
            kind: "<f8",
            _batch: self.batch.clone(),
        }))
    }

    /// A column of numbers without a copy; `None` for one that holds no numbers, or whole
    /// numbers with gaps.
    fn column(&self, name: &str) -> PyResult<Option<NumberBuffer>> {
        let array = self.numbers(name)?;
        let (address, kind, width) = match array.data_type() {
            DataType::Float64 => {
                (array.as_primitive::<Float64Type>().values().as_ptr() as usize, "<f8", 8)
            }
            DataType::UInt32 if array.null_count() == 0 => {
                (array.as_primitive::<UInt32Type>().values().as_ptr() as usize, "<u4", 4)
            }
            _ => return Ok(None),
        };
        let shape = vec![array.len()];
        Ok(Some(NumberBuffer {
            address,
            shape,
            strides: vec![width],
            kind,
            _batch: self.batch.clone(),
        }))
    }

    /// A column as Python objects, with `None` for gaps.
    fn objects<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Vec<Bound<'py, PyAny>>> {
        objects(py, self.numbers(name)?)
    }

    /// The columns as a stream of the Arrow C data interface: nothing is copied.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // A schema is a wish that a producer may leave unfulfilled.
        let _ = requested_schema;
        let schema = self.batch.schema();
        let batches = RecordBatchIterator::new([Ok(self.batch.clone())], schema);
        let stream = FFI_ArrowArrayStream::new(Box::new(batches));
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }

    /// The schema by the Arrow C data interface.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        let schema = self.batch.schema();
        let schema = FFI_ArrowSchema::try_from(schema.as_ref()).map_err(error::inside)?;
        PyCapsule::new_with_value(py, schema, c"arrow_schema")
    }
}

fn objects<'py>(py: Python<'py>, array: &ArrayRef) -> PyResult<Vec<Bound<'py, PyAny>>> {
    use arrow_array::types::{Int8Type, Int16Type};
    let none = || py.None().into_bound(py);
    let text = |value: Option<&str>| value.into_pyobject(py).map_err(PyErr::from);
    match array.data_type() {
        DataType::Float64 => {
            array.as_primitive::<Float64Type>().iter().map(|v| Ok(v.into_pyobject(py)?)).collect()
        }
        DataType::UInt32 => {
            array.as_primitive::<UInt32Type>().iter().map(|v| Ok(v.into_pyobject(py)?)).collect()
        }
        DataType::Boolean => array
            .as_boolean()
            .iter()
            .map(|value| {
                value.map_or_else(|| Ok(none()), |v| Ok(v.into_pyobject(py)?.to_owned().into_any()))
            })
            .collect(),
        DataType::Utf8 => array.as_string::<i32>().iter().map(text).collect(),
        DataType::Dictionary(key, _) => {
            // One Python string for each word of the set.
            let words: Vec<Bound<'_, PyAny>> = array
                .as_any_dictionary()
                .values()
                .as_string::<i32>()
                .iter()
                .map(text)
                .collect::<PyResult<_>>()?;
            let word = |key: Option<usize>| {
                key.and_then(|key| words.get(key).cloned()).unwrap_or_else(none)
            };
            Ok(if **key == DataType::Int8 {
                let keys = array.as_dictionary::<Int8Type>().keys().iter();
                keys.map(|key| word(key.map(|key| key as usize))).collect()
            } else {
                let keys = array.as_dictionary::<Int16Type>().keys().iter();
                keys.map(|key| word(key.map(|key| key as usize))).collect()
            })
        }
        other => Err(error::inside(format!("a column of {other}"))),
    }
}

/// Numbers in memory, as NumPy's array interface says about them. It keeps them alive.
#[pyclass(name = "Block", frozen, module = "chordal._chordal")]
pub struct NumberBuffer {
    address: usize,
    shape: Vec<usize>,
    strides: Vec<usize>,
    kind: &'static str,
    _batch: RecordBatch,
}

#[pymethods]
impl NumberBuffer {
    /// What `numpy.asarray` asks for.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let tuple = |values: &[usize]| pyo3::types::PyTuple::new(py, values);
        let interface = PyDict::new(py);
        interface.set_item("version", 3)?;
        interface.set_item("typestr", self.kind)?;
        interface.set_item("shape", tuple(&self.shape)?)?;
        interface.set_item("strides", tuple(&self.strides)?)?;
        let read_only = true;
        interface.set_item("data", (self.address, read_only))?;
        Ok(interface)
    }
}

/// Points or other rows of doubles as an array (rows, `width`).
pub fn rows<const N: usize>(values: Vec<[f64; N]>) -> PyResult<NumberBuffer> {
    let shape = vec![values.len(), N];
    let values: Vec<f64> = values.into_iter().flatten().collect();
    let array = Float64Array::from(values);
    let address = array.values().as_ptr() as usize;
    let field = arrow_schema::Field::new("rows", DataType::Float64, false);
    let schema = Arc::new(arrow_schema::Schema::new(vec![field]));
    let retained = RecordBatch::try_new(schema, vec![Arc::new(array)]).map_err(error::inside)?;
    Ok(NumberBuffer { address, shape, strides: vec![8 * N, 8], kind: "<f8", _batch: retained })
}

/// Triangles as rows of the numbers of their vertices.
pub fn indices(values: Vec<[u32; 3]>) -> PyResult<NumberBuffer> {
    let shape = vec![values.len(), 3];
    let array = arrow_array::UInt32Array::from(values.into_iter().flatten().collect::<Vec<u32>>());
    let address = array.values().as_ptr() as usize;
    let field = arrow_schema::Field::new("indices", DataType::UInt32, false);
    let schema = Arc::new(arrow_schema::Schema::new(vec![field]));
    let retained = RecordBatch::try_new(schema, vec![Arc::new(array)]).map_err(error::inside)?;
    Ok(NumberBuffer { address, shape, strides: vec![12, 4], kind: "<u4", _batch: retained })
}
