"""Tables that correct one axis: values by index at equal spacing, or rows with positions."""
