// Orders.
