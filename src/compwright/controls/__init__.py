"""The one door to a control: open its files, decode them with both readers, compare them."""
